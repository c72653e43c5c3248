// Angles: radians in the library, degrees where people read and write them.
#pragma once

#include <numbers>

namespace fieldfab {

inline constexpr double radians_per_degree = std::numbers::pi / 180;
inline constexpr double degrees_per_radian = 180 / std::numbers::pi;

constexpr double to_radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double to_degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace fieldfab
