/// Sums, products and hulls of intervals, for Fields over Fields; unknown if a result is not
/// finite.
#pragma once

#include <algorithm>
#include <cmath>

#include "fieldfab/core/interval.h"

namespace fieldfab {

inline Interval plus(const Interval& a, const Interval& b) {
  const float lower = a.lower + b.lower, upper = a.upper + b.upper;
  if (lower != lower || upper != upper || std::isinf(lower) || std::isinf(upper)) return Interval::unknown();
  return {lower, upper, a.maybe_nan || b.maybe_nan};
}
/// The smallest interval that contains both.
inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper), a.maybe_nan || b.maybe_nan};
}
inline Interval times(const Interval& a, const Interval& b) {
  const float ll = a.lower * b.lower, lu = a.lower * b.upper, ul = a.upper * b.lower, uu = a.upper * b.upper;
  const float lower = std::min(std::min(ll, lu), std::min(ul, uu)),
              upper = std::max(std::max(ll, lu), std::max(ul, uu));
  if (a.maybe_nan || b.maybe_nan || !std::isfinite(ll + lu) || !std::isfinite(ul + uu)) return Interval::unknown();
  return {lower, upper, false};
}

}  // namespace fieldfab
