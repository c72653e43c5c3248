/// Bounds of a Field over a box that follow its slope: two parallel planes instead of two numbers.
#pragma once

#include <array>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// For each point p of a box, the value lies within `error` of value + slope . (p - centre). The error falls with the square of
/// the box's size where the function is smooth, that of an interval only in proportion to it (mean value form; Moore 1966).
struct PlaneBounds {
  bool known = false;              ///< false where the Field does not tell its slopes; then the rest means nothing
  Vec3 centre = Vec3::Zero();      ///< of the box
  Vec3 half = Vec3::Zero();        ///< half of the box's sides
  double value = 0;                ///< at the centre
  Vec3 slope = Vec3::Zero();       ///< per mm
  double error = 0;                ///< rounding of values to single precision included
  std::array<Interval, 3> slopes;  ///< along x, y and z, as Field::slopes() gives them

  /// No value in the box is below this.
  [[nodiscard]] double lower() const { return value - slope.cwiseAbs().dot(half) - error; }
  /// No value in the box is above this.
  [[nodiscard]] double upper() const { return value + slope.cwiseAbs().dot(half) + error; }
};

/// Bounds over a box of finite size: one value and three slopes.
PlaneBounds plane_bounds(const Field& field, const Box& box) noexcept;

}  // namespace fieldfab
