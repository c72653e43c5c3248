/// Interval arithmetic in single precision: bounds of the values of a Field over a box.
///
/// Soundness: the reference evaluator rounds each operation to the nearest float. Rounding to nearest is monotone. For
/// the operations + - * / sqrt min max abs neg floor ceil, an interval with ends computed by the same rounding
/// therefore contains each value that the evaluator can produce, and no widening is needed. sin, exp and similar
/// functions are not proved to be monotone in their last bits; their intervals are widened by some units in the last
/// place. An operation that can yield NaN (0/0, inf-inf, sqrt of a negative number) sets `maybe_nan`; each decision
/// that rests on the interval is then undecided.
#pragma once

#include <algorithm>
#include <limits>

namespace fieldfab {

/// A closed interval [lower, upper] with lower <= upper. `maybe_nan` is set if the value may be NaN at some point of
/// the box.
struct Interval {
  float lower = 0;
  float upper = 0;
  bool maybe_nan = false;

  /// Returns the interval of one number.
  static constexpr Interval of(float value) { return {value, value, false}; }
  /// Returns the interval that contains all numbers and NaN.
  static constexpr Interval unknown() {
    return {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(), true};
  }

  /// Whether all values are below zero: the box is inside the solid.
  [[nodiscard]] constexpr bool inside() const { return upper < 0 && !maybe_nan; }
  /// Whether all values are above zero: the box is outside the solid.
  [[nodiscard]] constexpr bool outside() const { return lower > 0 && !maybe_nan; }
  /// Whether the box is inside or outside the solid.
  [[nodiscard]] constexpr bool decided() const { return inside() || outside(); }
  /// Whether the interval contains `value`; for NaN, whether `maybe_nan` is set.
  [[nodiscard]] constexpr bool contains(float value) const {
    return value != value ? maybe_nan : lower <= value && value <= upper;
  }
  constexpr bool operator==(const Interval&) const = default;
};

}  // namespace fieldfab
