#include "fieldfab/field/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr float far = far_from_surface;
/// Limits of a walk: number of steps, longest step, and remaining distance on arrival, mm.
constexpr int steps = 8;
constexpr double longest_step = 2, arrived = 1e-5;
/// Points inside at this distance or more, mm, are verified; points outside, if their first
/// estimate was smaller. The radii of the search rings, mm.
constexpr float doubted = 0.02F, narrowest = 0.005F, widest = 1;

/// Walks from points along the Field's gradient to its surface.
class Walks {
 public:
  Walks(const std::array<float, 3>* places, std::size_t count, float* distances)
      : places_(places), count_(count), distances_(distances), all_(count) {
    for (std::size_t i = 0; i < count; ++i) all_[i] = i;
  }

  void run(const Field& solid) {
    // Most points are near the surface, in a restriction that contains little of the solid. Points
    // farther away start again without it.
    std::vector<std::size_t> far_ones;
    go(solid, all_, 0.25, &far_ones);
    if (!far_ones.empty()) go(solid, far_ones, steps * longest_step, nullptr);
    std::vector<std::size_t> doubtful;
    for (const std::size_t i : all_)
      if (distances_[i] < -doubted ||
          (distances_[i] > 2 * std::max<double>(estimate_[i], doubted) && estimate_[i] < widest))
        doubtful.push_back(i);
    look_around(solid, std::move(doubtful));
  }

 private:
  [[nodiscard]] Vec3 place(std::size_t i) const { return {places_[i][0], places_[i][1], places_[i][2]}; }

  [[nodiscard]] double walked(std::size_t i) const {
    return (at_.col(static_cast<Eigen::Index>(i)).cast<double>() - place(i)).norm();
  }

  /// Walks from points. Points that leave the restriction are appended to `leavers`, if it is not
  /// null.
  void go(const Field& solid, std::vector<std::size_t> points, double reach, std::vector<std::size_t>* leavers) {
    Box box{place(points[0]), place(points[0])};
    for (const std::size_t i : points) box = hull(box, {place(i), place(i)});
    const Restriction here = solid.restricted(box.grown(reach + 0.01));
    std::vector<float> first(count_), across(count_, far);
    for (const std::size_t i : points) at_.col(i) = place(i).cast<float>();
    for (int step = 0; step < steps && !points.empty(); ++step) {
      const std::size_t n = points.size();
      for (std::size_t k = 0; k < n; ++k)
        x_[k] = at_(0, points[k]), y_[k] = at_(1, points[k]), z_[k] = at_(2, points[k]);
      here.field->gradients({x_.data(), y_.data(), z_.data(), n}, value_.data(), {dx_.data(), dy_.data(), dz_.data()});
      std::size_t on_the_way = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = points[k];
        if (step == 0) first[i] = value_[k];
        // If a walk crosses the surface repeatedly (noise between samples), the distance is at most
        // that of a crossing.
        if ((value_[k] < 0) != (first[i] < 0)) across[i] = std::min(across[i], static_cast<float>(walked(i)));
        const Vec3 slope(dx_[k], dy_[k], dz_[k]);
        const double steepness = slope.norm();
        const bool leads = steepness > 1e-9 && slope.allFinite() && std::isfinite(value_[k]);
        const double left = leads ? std::abs(value_[k]) / steepness : far;
        if (step == 0) estimate_[i] = std::min(left, std::abs(static_cast<double>(value_[k])));
        if (leads)
          at_.col(i) -=
              (slope * (std::clamp(value_[k] / steepness, -longest_step, longest_step) / steepness)).cast<float>();
        const double way = walked(i);
        if (leavers != nullptr && (way > reach || !leads)) {
          leavers->push_back(i);
          continue;
        }
        const float distance = left < 0.1 * way + 1e-3 ? std::min(static_cast<float>(way), across[i]) : across[i];
        distances_[i] = std::copysign(distance, first[i]);
        if (left > arrived && leads) points[on_the_way++] = i;
      }
      points.resize(on_the_way);
    }
  }

  /// If values are not distances, a walk may end too far away or fail. Finds the smallest of ever
  /// wider rings that contains a point of the other side.
  void look_around(const Field& solid, std::vector<std::size_t> points) {
    for (float radius = narrowest; radius < widest && !points.empty(); radius *= 1.5F) {
      std::size_t left = 0;
      for (const std::size_t i : points) {
        if (std::abs(distances_[i]) <= radius) continue;
        if (passes_surface(solid, i, radius))
          distances_[i] = std::copysign(radius, distances_[i]);
        else
          points[left++] = i;
      }
      points.resize(left);
    }
  }

  /// Whether any of 26 points around a point is on the other side of the surface.
  bool passes_surface(const Field& solid, std::size_t i, float radius) {
    constexpr std::size_t around = 27;
    std::array<float, around> x, y, z, value;
    for (std::size_t k = 0; k < around; ++k) {
      const Eigen::Vector3f way(static_cast<float>(k % 3) - 1, static_cast<float>(k / 3 % 3) - 1,
                                static_cast<float>(k / 9) - 1);
      const Eigen::Vector3f p = place(i).cast<float>() + (k == around / 2 ? way : way.normalized() * radius);
      x[k] = p.x(), y[k] = p.y(), z[k] = p.z();
    }
    solid.values({x.data(), y.data(), z.data(), around}, value.data());
    return std::any_of(value.begin(), value.end(), [&](float v) { return (v < 0) != (value[around / 2] < 0); });
  }

  const std::array<float, 3>* places_;
  std::size_t count_;
  float* distances_;
  std::vector<std::size_t> all_;
  std::vector<double> estimate_ = std::vector<double>(count_);  ///< lower estimate of each distance
  Eigen::Matrix3Xf at_{3, static_cast<Eigen::Index>(count_)};
  std::vector<float> x_ = std::vector<float>(count_), y_ = x_, z_ = x_, value_ = x_, dx_ = x_, dy_ = x_, dz_ = x_;
};

}  // namespace

void surface_distances(const Field& solid, std::span<const std::array<float, 3>> places, std::span<float> distances) {
  constexpr std::size_t block = 4096;
  parallel_for((places.size() + block - 1) / block, [&](std::size_t b) {
    const std::size_t first = b * block;
    Walks(&places[first], std::min(block, places.size() - first), &distances[first]).run(solid);
  });
}

}  // namespace fieldfab
