// Interval arithmetic: one operation on intervals. core/interval.h explains why IEEE operations
// need no widening.
#include <algorithm>
#include <array>
#include <cmath>

#include "batch.h"
#include "fieldfab/frep/reference.h"
#include "functions.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

constexpr float margin = function_margin, smallest = function_slack, largest = largest_float;

float down(float value) { return std::min(value, largest) - (std::min(std::abs(value), largest) * margin + smallest); }
float up(float value) { return std::max(value, -largest) + (std::min(std::abs(value), largest) * margin + smallest); }
Interval widened(float lower, float upper, bool maybe_nan) {
  if (lower != lower || upper != upper) return Interval::unknown();
  return {down(lower), up(upper), maybe_nan};
}
Interval ordered(float lower, float upper, bool maybe_nan) {
  if (lower != lower || upper != upper) return Interval::unknown();
  return {lower, upper, maybe_nan};
}

/// Values of a function at two points, computed together: as lanes they cost little more than one.
template <Opcode op>
std::array<float, 2> at_both(std::array<float, 2> a, std::array<float, 2> b) {
  const Floats<2> first{a[0], a[1]}, second{b[0], b[1]};
  const Floats<2> values = function_in_lanes<op, 2>(first, second);
  return {values[0], values[1]};
}
template <Opcode op>
std::array<float, 2> at_both(float lower, float upper) {
  return at_both<op>({lower, upper}, {lower, upper});
}

Interval divide(const Interval& a, const Interval& b, bool nan) {
  nan = nan || (has_zero(a) && has_zero(b)) || (has_infinity(a) && has_infinity(b));
  if (has_zero(b)) return {-infinity, infinity, nan};
  float lower = infinity, upper = -infinity;
  for (const float x : {a.lower, a.upper})
    for (const float y : {b.lower, b.upper}) {
      const float quotient = x / y;
      if (quotient != quotient) return {-infinity, infinity, true};
      lower = std::min(lower, quotient);
      upper = std::max(upper, quotient);
    }
  return {lower, upper, nan};
}

/// sin over [lower, upper] for quarter 0, cos for 1. Beyond a few thousand radians the positions of
/// the crests are too inaccurate.
template <Opcode op>
Interval wave(const Interval& a) {
  const bool nan = a.maybe_nan || has_infinity(a);
  const Interval full{-1, 1, nan};
  if (!(std::abs(a.lower) < 4096) || !(std::abs(a.upper) < 4096)) return full;
  constexpr double pi = 3.14159265358979323846;
  const double phase = op == Opcode::sine ? 0 : pi / 2, low = a.lower + phase, high = a.upper + phase;
  if (high - low >= 2 * pi) return full;
  const auto [one, other] = at_both<op>(a.lower, a.upper);
  float lower = std::min(one, other), upper = std::max(one, other);
  constexpr double slack = 1e-9, turn = 1 / (2 * pi);  // a crest just beyond an end counts as inside
  if (std::floor((high - pi / 2 + slack) * turn) > std::floor((low - pi / 2 - slack) * turn)) upper = 1;
  if (std::floor((high + pi / 2 + slack) * turn) > std::floor((low + pi / 2 - slack) * turn)) lower = -1;
  return {std::max(-1.0F, down(lower)), std::min(1.0F, up(upper)), nan};
}

Interval tangent(const Interval& a) {
  constexpr double pi = 3.14159265358979323846;
  const bool nan = a.maybe_nan || has_infinity(a);
  if (!(std::abs(a.lower) < 4096) || !(std::abs(a.upper) < 4096)) return {-infinity, infinity, nan};
  constexpr double slack = 1e-6;
  if (std::floor((a.upper + pi / 2 + slack) / pi) > std::floor((a.lower + pi / 2 - slack) / pi))
    return {-infinity, infinity, nan};
  const auto [lower, upper] = at_both<Opcode::tangent>(a.lower, a.upper);
  return widened(lower, upper, nan);
}

/// Applies a function that is increasing, or decreasing, over its domain [low, high] and NaN outside.
template <Opcode op, bool falls = false>
Interval monotone(const Interval& a, float low, float high) {
  const bool nan = a.maybe_nan || a.lower < low || a.upper > high;
  if (a.upper < low || a.lower > high) return Interval::unknown();
  const auto [lower, upper] = at_both<op>(std::max(a.lower, low), std::min(a.upper, high));
  return falls ? widened(upper, lower, nan) : widened(lower, upper, nan);
}

/// The least and the greatest value of a function at the corners of a rectangle; `maybe_nan` if one is NaN.
template <Opcode op>
Interval at_corners(const Interval& a, const Interval& b) {
  const auto [ll, lu] = at_both<op>({a.lower, a.lower}, {b.lower, b.upper});
  const auto [ul, uu] = at_both<op>({a.upper, a.upper}, {b.lower, b.upper});
  return {std::min({ll, lu, ul, uu}), std::max({ll, lu, ul, uu}), ll != ll || lu != lu || ul != ul || uu != uu};
}

Interval power(const Interval& a, const Interval& b, bool nan) {
  // A constant whole exponent is the most frequent case: monotone on each side of zero.
  if (b.lower == b.upper && std::floor(b.lower) == b.lower && std::abs(b.lower) < 1e6F) {
    const float n = b.lower;
    if (n == 0) return {1, 1, nan};
    if (n < 0 && has_zero(a)) return {-infinity, infinity, nan};
    const auto [l, u] = at_both<Opcode::power>({a.lower, a.upper}, {n, n});
    if (l != l || u != u) return Interval::unknown();
    const bool even = std::fmod(n, 2.0F) == 0;
    const float least = even && has_zero(a) ? 0 : std::min(l, u);
    const Interval wide = widened(least, std::max(l, u), nan);
    return {even ? std::max(0.0F, wide.lower) : wide.lower, wide.upper, wide.maybe_nan};
  }
  if (a.lower > 0) {
    auto [lower, upper, none] = at_corners<Opcode::power>(a, b);
    if (none) return Interval::unknown();
    // x^y has extrema inside the rectangle only where ln x or y is 0; its value is 1 there.
    if (a.lower <= 1 && a.upper >= 1) lower = std::min(lower, 1.0F), upper = std::max(upper, 1.0F);
    if (b.lower <= 0 && b.upper >= 0) lower = std::min(lower, 1.0F), upper = std::max(upper, 1.0F);
    const Interval wide = widened(lower, upper, nan);
    return {std::max(0.0F, wide.lower), wide.upper, wide.maybe_nan};
  }
  return Interval::unknown();
}

Interval arctangent2(const Interval& y, const Interval& x, bool nan) {
  constexpr float pi = 3.1415927410125732F;  // float(pi), which exceeds pi
  if (x.lower > 0 || y.lower > 0 || y.upper < 0) {
    const Interval values = at_corners<Opcode::arctangent2>(y, x);
    return widened(values.lower, values.upper, nan);
  }
  return {-pi, pi, nan};
}

Interval modulo(const Interval& a, const Interval& b, bool nan) {
  nan = nan || has_zero(b) || has_infinity(a) || has_infinity(b);
  // a - b * floor(a / b), with the same steps as the evaluator.
  const Interval quotient = divide(a, b, nan);
  const Interval whole{std::floor(quotient.lower), std::floor(quotient.upper), quotient.maybe_nan};
  const Interval product = multiply(b, whole, nan || whole.maybe_nan);
  return add(a, {-product.upper, -product.lower, false}, nan || product.maybe_nan);
}

}  // namespace

Interval apply(Opcode op, Interval a, Interval b) {
  const bool nan = a.maybe_nan || (info(op).arity == 2 && b.maybe_nan);
  switch (op) {
    case Opcode::constant:
    case Opcode::x:
    case Opcode::y:
    case Opcode::z:
    case Opcode::opened: return a;
    case Opcode::sine: return wave<Opcode::sine>(a);
    case Opcode::cosine: return wave<Opcode::cosine>(a);
    case Opcode::tangent: return tangent(a);
    case Opcode::arcsine: return monotone<Opcode::arcsine>(a, -1, 1);
    case Opcode::arccosine: return monotone<Opcode::arccosine, true>(a, -1, 1);
    case Opcode::arctangent: return monotone<Opcode::arctangent>(a, -infinity, infinity);
    case Opcode::absolute: return absolute(a);
    case Opcode::square: return square(a);
    case Opcode::square_root:
      if (a.upper < 0) return Interval::unknown();
      return {std::sqrt(std::max(a.lower, 0.0F)), std::sqrt(a.upper), nan || a.lower < 0};
    case Opcode::negate: return negate(a);
    case Opcode::exponential: {
      const Interval wide = monotone<Opcode::exponential>(a, -infinity, infinity);
      return {std::max(0.0F, wide.lower), wide.upper, wide.maybe_nan};
    }
    case Opcode::logarithm: return monotone<Opcode::logarithm>(a, 0, infinity);
    case Opcode::floor: return {std::floor(a.lower), std::floor(a.upper), nan};
    case Opcode::ceiling: return {std::ceil(a.lower), std::ceil(a.upper), nan};
    case Opcode::add: return add(a, b, nan);
    case Opcode::subtract: return add(a, negate(b), nan);
    case Opcode::multiply: return multiply(a, b, nan);
    case Opcode::divide: return divide(a, b, nan);
    case Opcode::minimum: return minimum(a, b, nan);
    case Opcode::maximum: return maximum(a, b, nan);
    case Opcode::power: return power(a, b, nan);
    case Opcode::arctangent2: return arctangent2(a, b, nan);
    case Opcode::modulo: return modulo(a, b, nan);
    case Opcode::compare:
      return ordered(a.lower > b.upper    ? 1.0F
                     : a.lower >= b.upper ? 0.0F
                                          : -1.0F,
                     a.upper < b.lower    ? -1.0F
                     : a.upper <= b.lower ? 0.0F
                                          : 1.0F,
                     nan);
  }
  return Interval::unknown();
}

bool finite_interval(Opcode op, float a_lower, float a_upper, float b_lower, float b_upper, float* out) {
  const Interval range = apply(op, {a_lower, a_upper, false}, {b_lower, b_upper, false});
  out[0] = range.lower, out[1] = range.upper;
  return !range.maybe_nan && std::isfinite(range.lower) && std::isfinite(range.upper);
}

}  // namespace fieldfab::frep
