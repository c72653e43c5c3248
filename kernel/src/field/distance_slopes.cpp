#include "fieldfab/field/distance_slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fieldfab {
namespace {

Interval rounded(double lower, double upper) { return {static_cast<float>(lower), static_cast<float>(upper), false}; }

}  // namespace

Interval slope_away_from(const Vec3& way, double reach, const Vec3& direction) {
  const double steepest = direction.norm(), distance = way.norm();
  if (!(distance > reach) || !(steepest > 0)) return rounded(-steepest, steepest);
  const double width = std::asin(reach / distance);
  const double angle = std::acos(std::clamp(way.dot(direction) / (distance * steepest), -1.0, 1.0));
  return rounded(steepest * std::cos(std::min(angle + width, std::numbers::pi)),
                 steepest * std::cos(std::max(angle - width, 0.0)));
}

NormalCone::NormalCone(std::span<const Vec3> normals) : normals_(normals) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& normal : normals) middle += normal;
  if (!(middle.norm() > 1e-6)) return;
  middle.normalize();
  // The mean direction lies where most normals are; steps towards the farthest normal move it to
  // the centre of the cone (Badoiu and Clarkson 2003).
  constexpr int turns = 16;
  for (int turn = 1; turn <= turns && cosine_ < 0.999; ++turn) {
    const auto farther = [&](const Vec3& a, const Vec3& b) { return a.dot(middle) < b.dot(middle); };
    const Vec3& farthest = *std::min_element(normals.begin(), normals.end(), farther);
    if (const double cosine = farthest.dot(middle); cosine > cosine_) cosine_ = cosine, axis_ = middle;
    middle += (farthest - middle) / (turn + 1.0);
    if (!(middle.norm() > 1e-6)) return;
    middle.normalize();
  }
}

Interval NormalCone::along(const Vec3& direction) const {
  const double steepest = direction.norm();
  double lower = steepest, upper = -steepest;
  for (const Vec3& normal : normals_) {
    const double slope = normal.dot(direction);
    lower = std::min(lower, slope), upper = std::max(upper, slope);
  }
  // A mean of unit vectors has a length from the cosine to 1, so normalisation can only increase
  // magnitudes.
  const double longest = cosine_ > 0 ? 1 / cosine_ : std::numeric_limits<double>::infinity();
  if (lower < 0) lower = std::max(lower * longest, -steepest);
  if (upper > 0) upper = std::min(upper * longest, steepest);
  return rounded(lower, upper);
}

Interval common(const Interval& a, const Interval& b) {
  const float lower = std::max(a.lower, b.lower), upper = std::min(a.upper, b.upper);
  return {std::min(lower, upper), std::max(lower, upper), a.maybe_nan || b.maybe_nan};
}

}  // namespace fieldfab
