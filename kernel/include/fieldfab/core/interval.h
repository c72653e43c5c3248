/// Interval arithmetic on single-precision numbers: what a Field can take on over a box.
///
/// Soundness. The reference evaluator rounds every operation to the nearest float. Rounding to nearest is monotone, so for
/// + - * / sqrt min max abs neg floor ceil the interval whose ends are computed with that same rounding holds every value that
/// evaluator can produce: no widening is needed. sin, exp and their like are not promised to be monotone in their last
/// bits; their intervals are widened by some ulps. An operation that can yield NaN (0/0, inf-inf, sqrt of a negative
/// part) sets `maybe_nan`; then every decision that rests on the interval must be taken as undecided.
#pragma once

#include <algorithm>
#include <limits>

namespace fieldfab {

/// A closed interval [lower, upper]; `maybe_nan` when some point of the box may evaluate to NaN.
struct Interval {
  float lower = 0;
  float upper = 0;
  bool maybe_nan = false;

  /// The interval of one number.
  static constexpr Interval of(float value) { return {value, value, false}; }
  /// Nothing is known: every number, and NaN.
  static constexpr Interval unknown() {
    return {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(), true};
  }

  /// Every value is below zero: the box is wholly inside.
  [[nodiscard]] constexpr bool inside() const { return upper < 0 && !maybe_nan; }
  /// Every value is above zero: the box is wholly outside.
  [[nodiscard]] constexpr bool outside() const { return lower > 0 && !maybe_nan; }
  [[nodiscard]] constexpr bool decided() const { return inside() || outside(); }
  [[nodiscard]] constexpr bool contains(float value) const {
    return value != value ? maybe_nan : lower <= value && value <= upper;
  }
  constexpr bool operator==(const Interval&) const = default;
};

}  // namespace fieldfab
