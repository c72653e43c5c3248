/// Bounds of directional derivatives of signed distances, for implementations of Field::slopes().
#pragma once

#include <span>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// Bounds the slope along `direction` of the distance to a convex part. `way` is the vector from the nearest point of
/// the part to the centre of a ball, `reach` the ball's radius, mm; the bound holds for all points of the ball. The
/// projection onto a convex set and its residual are both non-expansive. Returns [-|direction|, |direction|] if the
/// ball meets the part.
Interval slope_away_from(const Vec3& way, double reach, const Vec3& direction);

/// The convex cone spanned by unit normals: all sums of their non-negative multiples. The gradient of a signed distance
/// lies in the cone of the normals of the faces at the nearest point; otherwise a point would be behind the planes of
/// all these faces and yet outside the solid.
class NormalCone {
 public:
  /// Keeps a view of `normals`, which must outlive this object.
  explicit NormalCone(std::span<const Vec3> normals);

  /// Axis of the cone, of length 1, or the zero vector if there is none; and a lower bound of the cosine of its half
  /// angle.
  [[nodiscard]] const Vec3& axis() const { return axis_; }
  [[nodiscard]] double cosine() const { return cosine_; }
  /// Returns the range of direction . u over the unit vectors u of the cone.
  [[nodiscard]] Interval along(const Vec3& direction) const;

 private:
  std::span<const Vec3> normals_;
  Vec3 axis_ = Vec3::Zero();
  double cosine_ = -1;
};

/// Returns the intersection of two intervals that overlap.
Interval common(const Interval& a, const Interval& b);

}  // namespace fieldfab
