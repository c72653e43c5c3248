/// Bounds of how fast distances change, for Fields that are signed distances to faces (Field::slopes()).
#pragma once

#include <span>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// How a distance changes along a direction where the nearest place is on one convex part: the part's place nearest to the middle
/// of a ball is at `way` from it, and the ball's radius is `reach`. A projection on a convex set, and what it leaves of a point,
/// move no more than the point does. All of [-|d|, |d|] where the ball reaches the part.
Interval slope_away_from(const Vec3& way, double reach, const Vec3& direction);

/// The directions that are sums of multiples, 0 or more, of some unit normals. The gradient of a signed distance is among those
/// of the faces at the nearest place: otherwise a point would lie behind all the planes of these faces and outside of the solid.
class NormalCone {
 public:
  explicit NormalCone(std::span<const Vec3> normals);

  /// The middle of the cone, of length 1 (0 where there is none), and the cosine of its half angle, at least.
  [[nodiscard]] const Vec3& axis() const { return axis_; }
  [[nodiscard]] double cosine() const { return cosine_; }
  /// The range of direction . u over the unit vectors u of the cone.
  [[nodiscard]] Interval along(const Vec3& direction) const;

 private:
  std::span<const Vec3> normals_;
  Vec3 axis_ = Vec3::Zero();
  double cosine_ = -1;
};

/// What both intervals hold, for two that both hold something.
Interval common(const Interval& a, const Interval& b);

}  // namespace fieldfab
