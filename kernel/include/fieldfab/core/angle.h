/// Angles: radians in the library, degrees in texts, options and files.
#pragma once

#include <numbers>

namespace fieldfab {

inline constexpr double radians_per_degree = std::numbers::pi / 180;
inline constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// Converts degrees to radians. Multiplies first, so that 180 gives pi exactly; a product with radians_per_degree may
/// differ in the last bit. NaN stays NaN.
constexpr double to_radians(double degrees) { return degrees * std::numbers::pi / 180; }
/// Converts radians to degrees in the same way: pi gives 180 exactly.
constexpr double to_degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace fieldfab
