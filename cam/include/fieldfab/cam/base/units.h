/// Units and coordinates of all CAM modules: lengths are millimetres and angles radians.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "fieldfab/core/angle.h"

namespace fieldfab::cam {

/// A point of a plane, mm.
using Vec2 = Eigen::Vector2d;

/// Whether an axis is rotary, by its index in x, y, z, a, b, c, u, v, w: its values are radians.
constexpr bool is_rotary(std::size_t axis) { return axis >= 3 && axis < 6; }

}  // namespace fieldfab::cam
