/// Chords of an arc within a tolerance.
#pragma once

#include <algorithm>
#include <cmath>

namespace fieldfab::cam {

/// Greatest distance of the short feeds that replace a curve of a program from the curve, mm.
inline constexpr double chord_tolerance = 0.001;

/// Returns the angle (radians) of the longest chord whose sagitta, its greatest distance from its arc, is at most
/// `tolerance` > 0: 2 arccos(1 - tolerance / radius). pi where the radius is `tolerance` or less, or NaN.
inline double chord_angle(double radius, double tolerance) {
  return 2 * std::acos(std::max(0.0, 1 - tolerance / std::max(radius, tolerance)));
}

/// Returns the length of an arc (in the unit of `radius`) whose chord lies within `tolerance` > 0 of it, and which is
/// nearly the longest such arc: sqrt(8 radius tolerance), since the sagitta radius (1 - cos(length / (2 radius))) is at
/// most length^2 / (8 radius). A radius below `tolerance` counts as `tolerance`.
inline double chord_arc_length(double radius, double tolerance) {
  return 2 * std::sqrt(2 * tolerance * std::max(radius, tolerance));
}

}  // namespace fieldfab::cam
