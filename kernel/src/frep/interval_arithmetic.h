/// Interval operations that are cheap enough to be inlined into the evaluation of a tape. `nan`
/// states whether an argument may be NaN.
#pragma once

#include <algorithm>
#include <cmath>

#include "fieldfab/core/interval.h"

namespace fieldfab::frep {

constexpr float infinity = std::numeric_limits<float>::infinity();

inline bool has_zero(const Interval& a) { return a.lower <= 0 && a.upper >= 0; }
inline bool has_infinity(const Interval& a) { return a.lower == -infinity || a.upper == infinity; }

inline Interval add(const Interval& a, const Interval& b, bool nan) {
  nan = nan || (a.upper == infinity && b.lower == -infinity) || (a.lower == -infinity && b.upper == infinity);
  const float lower = a.lower + b.lower, upper = a.upper + b.upper;
  return {lower == lower ? lower : -infinity, upper == upper ? upper : infinity, nan};
}

inline Interval multiply(const Interval& a, const Interval& b, bool nan) {
  nan = nan || (has_zero(a) && has_infinity(b)) || (has_infinity(a) && has_zero(b));
  // 0 * infinity is 0 here: the infinity stands for some large finite number.
  const auto product = [](float x, float y) { return x == 0 || y == 0 ? 0 : x * y; };
  const float ll = product(a.lower, b.lower), lu = product(a.lower, b.upper), ul = product(a.upper, b.lower),
              uu = product(a.upper, b.upper);
  return {std::min(std::min(ll, lu), std::min(ul, uu)), std::max(std::max(ll, lu), std::max(ul, uu)), nan};
}

inline Interval square(const Interval& a) {
  const float l = a.lower * a.lower, u = a.upper * a.upper;
  return {has_zero(a) ? 0 : std::min(l, u), std::max(l, u), a.maybe_nan};
}

inline Interval negate(const Interval& a) { return {-a.upper, -a.lower, a.maybe_nan}; }

inline Interval absolute(const Interval& a) {
  const float l = std::abs(a.lower), u = std::abs(a.upper);
  return {has_zero(a) ? 0 : std::min(l, u), std::max(l, u), a.maybe_nan};
}

inline Interval minimum(const Interval& a, const Interval& b, bool nan) {
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper), nan};
}

inline Interval maximum(const Interval& a, const Interval& b, bool nan) {
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper), nan};
}

}  // namespace fieldfab::frep
