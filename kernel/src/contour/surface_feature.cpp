#include "surface_feature.h"

#include <algorithm>
#include <cmath>

namespace fieldfab::contouring {

void Samples::ask(const Field& solid) {
  for (auto* values : {&value_, &dx_, &dy_, &dz_}) values->resize(x_.size());
  solid.gradients({x_.data(), y_.data(), z_.data(), x_.size()}, value_.data(), {dx_.data(), dy_.data(), dz_.data()});
}

float Samples::distance(std::size_t i) const {
  const float distance = value_[i] / slope(i).norm();
  return std::isfinite(distance) ? distance : 0.0F;
}

float FeatureSearch::least_cosine() const {
  float least = 1;
  for (const SurfacePoint& point : found) least = std::min(least, point.normal.dot(found.front().normal));
  return least;
}

PlacedVertex feature_near(const Field& solid, const Box& known, const Eigen::Vector3f& centre, float reach,
                          FeatureSearch& search) {
  constexpr int directions = 27;
  Samples& around = search.around;
  around.clear();
  for (int i = 0; i < directions; ++i) {
    Eigen::Vector3f direction = Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).cast<float>();
    if (!direction.isZero(0)) direction.normalize();
    around.add(centre + reach * direction);
  }
  constexpr int newton_steps = 3;
  around.ask(solid);
  for (int step = 0; step < newton_steps; ++step) {
    bool settled = true;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const float length = around.slope(i).norm();
      settled = settled && std::abs(around.distance(i)) < 1e-4F * reach;
      if (length > 0 && std::isfinite(length))
        around.step(i, -std::clamp(around.distance(i), -reach, reach) / length * around.slope(i));
    }
    if (settled) break;
    around.ask(solid);
  }
  std::vector<SurfacePoint>& found = search.found;
  found.clear();
  for (std::size_t i = 0; i < around.size(); ++i) {
    const float length = around.slope(i).norm();
    if (length > 0 && std::isfinite(length) && std::abs(around.distance(i)) < 0.01F * reach &&
        (around.point(i) - centre).squaredNorm() < 4 * reach * reach && known.contains(around.point(i).cast<double>()))
      found.push_back({around.point(i), around.slope(i) / length});
  }
  const Vec3 middle = centre.cast<double>(), side = Vec3::Constant(1.5 * static_cast<double>(reach));
  return found.empty() ? PlacedVertex{middle, 0, 0} : place_vertex(found, {middle - side, middle + side});
}

}  // namespace fieldfab::contouring
