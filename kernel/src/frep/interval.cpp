// Interval arithmetic: one operation on intervals. core/interval.h explains why IEEE operations
// need no widening.
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
Interval wave(Opcode op, const Interval& a) {
  const bool nan = a.maybe_nan || has_infinity(a);
  const Interval full{-1, 1, nan};
  if (!(std::abs(a.lower) < 4096) || !(std::abs(a.upper) < 4096)) return full;
  constexpr double pi = 3.14159265358979323846;
  const double phase = op == Opcode::sine ? 0 : pi / 2, low = a.lower + phase, high = a.upper + phase;
  if (high - low >= 2 * pi) return full;
  const float one = apply(op, a.lower), other = apply(op, a.upper);
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
  return widened(apply(Opcode::tangent, a.lower), apply(Opcode::tangent, a.upper), nan);
}

/// Applies a function that is increasing over its domain [low, high] and NaN outside.
template <class Function>
Interval growing(const Interval& a, float low, float high, const Function& function) {
  const bool nan = a.maybe_nan || a.lower < low || a.upper > high;
  if (a.upper < low || a.lower > high) return Interval::unknown();
  return widened(function(std::max(a.lower, low)), function(std::min(a.upper, high)), nan);
}

Interval power(const Interval& a, const Interval& b, bool nan) {
  // A constant whole exponent is the most frequent case: monotone on each side of zero.
  if (b.lower == b.upper && std::floor(b.lower) == b.lower && std::abs(b.lower) < 1e6F) {
    const float n = b.lower;
    if (n == 0) return {1, 1, nan};
    if (n < 0 && has_zero(a)) return {-infinity, infinity, nan};
    const float l = apply(Opcode::power, a.lower, n), u = apply(Opcode::power, a.upper, n);
    if (l != l || u != u) return Interval::unknown();
    const bool even = std::fmod(n, 2.0F) == 0;
    const float least = even && has_zero(a) ? 0 : std::min(l, u);
    const Interval wide = widened(least, std::max(l, u), nan);
    return {even ? std::max(0.0F, wide.lower) : wide.lower, wide.upper, wide.maybe_nan};
  }
  if (a.lower > 0) {
    float lower = infinity, upper = -infinity;
    for (const float x : {a.lower, a.upper})
      for (const float y : {b.lower, b.upper}) {
        const float value = apply(Opcode::power, x, y);
        if (value != value) return Interval::unknown();
        lower = std::min(lower, value);
        upper = std::max(upper, value);
      }
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
    float lower = infinity, upper = -infinity;
    for (const float a : {y.lower, y.upper})
      for (const float b : {x.lower, x.upper}) {
        const float value = apply(Opcode::arctangent2, a, b);
        lower = std::min(lower, value);
        upper = std::max(upper, value);
      }
    return widened(lower, upper, nan);
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
    case Opcode::sine:
    case Opcode::cosine: return wave(op, a);
    case Opcode::tangent: return tangent(a);
    case Opcode::arcsine: return growing(a, -1, 1, [](float v) { return apply(Opcode::arcsine, v); });
    case Opcode::arccosine: {
      const Interval flipped =
          growing({-a.upper, -a.lower, a.maybe_nan}, -1, 1, [](float v) { return apply(Opcode::arccosine, -v); });
      return flipped;
    }
    case Opcode::arctangent:
      return growing(a, -infinity, infinity, [](float v) { return apply(Opcode::arctangent, v); });
    case Opcode::absolute: return absolute(a);
    case Opcode::square: return square(a);
    case Opcode::square_root:
      if (a.upper < 0) return Interval::unknown();
      return {std::sqrt(std::max(a.lower, 0.0F)), std::sqrt(a.upper), nan || a.lower < 0};
    case Opcode::negate: return negate(a);
    case Opcode::exponential: {
      const Interval wide = growing(a, -infinity, infinity, [](float v) { return apply(Opcode::exponential, v); });
      return {std::max(0.0F, wide.lower), wide.upper, wide.maybe_nan};
    }
    case Opcode::logarithm: return growing(a, 0, infinity, [](float v) { return apply(Opcode::logarithm, v); });
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
