/// Linear bounds of a Field over a box: two parallel planes instead of two numbers.
#pragma once

#include <array>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// Linear bounds over a box: for each point p of it the value lies within `error` of value + slope . (p - centre). The
/// error is of second order in the box size where the function is smooth, that of an interval only of first order (mean
/// value form; Moore 1966).
struct PlaneBounds {
  /// false if the Field has no bounds of its slopes there; all other members are then undefined
  bool known = false;
  Vec3 centre = Vec3::Zero();      ///< centre of the box
  Vec3 half = Vec3::Zero();        ///< half of the box's sides, mm
  double value = 0;                ///< value at the centre
  Vec3 slope = Vec3::Zero();       ///< gradient of the linear part, value per mm
  double error = 0;                ///< half the distance of the planes, including the rounding of values to float
  std::array<Interval, 3> slopes;  ///< slopes along x, y and z, as Field::slopes() returns them

  /// Lower bound of the values in the box.
  [[nodiscard]] double lower() const { return value - slope.cwiseAbs().dot(half) - error; }
  /// Upper bound of the values in the box.
  [[nodiscard]] double upper() const { return value + slope.cwiseAbs().dot(half) + error; }
};

/// Computes the bounds over a finite box from one value and three slopes.
PlaneBounds plane_bounds(const Field& field, const Box& box) noexcept;

}  // namespace fieldfab
