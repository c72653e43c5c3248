// The transcendental functions in single precision: sin, cos, tan, asin, acos, atan, exp, ln, pow
// and atan2. They are the definition. One text serves a single number and vectors of lanes, so that
// the reference evaluator, the batch evaluators of all instruction sets and machine code get the
// same bits, whatever the C library.
//
// Each is computed in double precision without branches: the argument is reduced to a small range,
// where a polynomial is accurate to 1e-13. A result is therefore the nearest float, or in less than
// one case of a million its neighbour; docs/f-reps.md has the counts. packaging/fit_functions.py
// computes the coefficients. The first is exact, so that functions of tiny arguments are.
//
// Internal linkage on purpose: each instruction set compiles its own copy.
#pragma once

#include <bit>
#include <iterator>

#include "fieldfab/frep/opcode.h"
#include "lanes.h"

namespace fieldfab::frep {
namespace {

/// Addition and subtraction of this number round to a whole number, which is in the low bits of the
/// sum.
constexpr double rounder = 6755399441055744.0;  // 1.5 * 2^52
constexpr double half_pi = 1.57079632679489655800, infinite = __builtin_inf(), not_a_number = __builtin_nan("");

/// Arguments of sine, cosine and tangent up to this size; the C library handles larger ones.
constexpr float wave_limit = 1e6F;

template <std::size_t n, const auto& coefficients, std::size_t first, std::size_t count>
[[gnu::always_inline]] inline Doubles<n> partial_polynomial(const Doubles<n>* powers) {
  if constexpr (count == 1) {
    return all<n>(coefficients[first]);
  } else {
    constexpr std::size_t low = std::bit_floor(count - 1), level = std::bit_width(low) - 1;
    return partial_polynomial<n, coefficients, first, low>(powers) +
           powers[level] * partial_polynomial<n, coefficients, first + low, count - low>(powers);
  }
}

/// Returns the value of a polynomial, lowest coefficient first, by Estrin's scheme: halves are independent, so
/// that the processor computes them side by side.
template <std::size_t n, const auto& coefficients>
[[gnu::always_inline]] inline Doubles<n> polynomial(Doubles<n> x) {
  constexpr std::size_t count = std::size(coefficients), squares = std::bit_width(count - 1);
  Doubles<n> powers[squares];  // x, x^2, x^4
  powers[0] = x;
  for (std::size_t i = 1; i < squares; ++i) powers[i] = powers[i - 1] * powers[i - 1];
  return partial_polynomial<n, coefficients, 0, count>(powers);
}

// Parts of pi for the range reduction of Cody and Waite (1980): the first has trailing zeros, so that its product with
// a small whole number, or half of one, is exact.
constexpr double pi_high = 3.14159265346825122834, pi_low = 1.21542010130123844986e-10;

/// sin(r) / r for |r| <= pi / 2, of r^2.
constexpr double sine_series[] = {1.0,
                                  -0.1666666666666665,
                                  0.008333333333325933,
                                  -0.00019841269836469002,
                                  2.755731805568114e-06,
                                  -2.5051972921142235e-08,
                                  1.605097222815627e-10,
                                  -7.408054654083531e-13};

/// sin(x), or cos(x) = sin(x + pi / 2), for |x| <= wave_limit.
template <std::size_t n, bool cosine>
[[gnu::always_inline]] inline Floats<n> sine_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  Doubles<n> half_turns = x * 0.31830988618379067154;  // 1 / pi
  if constexpr (cosine) half_turns += 0.5;
  const Doubles<n> shifted = half_turns + rounder;
  Doubles<n> whole = shifted - rounder;
  if constexpr (cosine) whole -= 0.5;
  const Doubles<n> r = (x - whole * pi_high) - whole * pi_low;
  const Doubles<n> sine = r * polynomial<n, sine_series>(r * r);
  return rounded<n>(from_bits<n>(bits_of<n>(sine) ^ (bits_of<n>(shifted) << 63)));
}

/// sin(r) / r and cos(r) for |r| <= pi / 4, of r^2.
constexpr double short_sine_series[] = {1.0,
                                        -0.16666666666663885,
                                        0.008333333331079214,
                                        -0.00019841266916977214,
                                        2.7555990926917083e-06,
                                        -2.4805635996537525e-08};
constexpr double short_cosine_series[] = {1.0,
                                          -0.49999999999999967,
                                          0.04166666666663093,
                                          -0.0013888888882127924,
                                          2.480158262333795e-05,
                                          -2.755585550901141e-07,
                                          2.066550465988738e-09};

/// tan(x) for |x| <= wave_limit.
template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> tangent_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  const Doubles<n> shifted = x * 0.63661977236758134308 + rounder;  // 2 / pi
  const Doubles<n> whole = shifted - rounder;
  const Doubles<n> r = (x - whole * (pi_high / 2)) - whole * (pi_low / 2), s = r * r;
  const Bits<n> sine = bits_of<n>(r * polynomial<n, short_sine_series>(s));
  const Bits<n> cosine = bits_of<n>(polynomial<n, short_cosine_series>(s));
  // tan(r + pi / 2) = -cos(r) / sin(r)
  const Bits<n> odd = -(bits_of<n>(shifted) & 1);
  const Bits<n> above = (cosine & odd) | (sine & ~odd), below = ((sine ^ sign_bit) & odd) | (cosine & ~odd);
  return rounded<n>(from_bits<n>(above) / from_bits<n>(below));
}

/// 2^t for |t| <= 1/2.
constexpr double exponential_series[] = {1.0,
                                         0.6931471805599453,
                                         0.2402265069581299,
                                         0.055504108664760424,
                                         0.009618129159402869,
                                         0.0013333558179043307,
                                         0.0001540345585215541,
                                         1.5252686846079744e-05,
                                         1.3255224958253546e-06,
                                         1.0203121113519707e-07};

/// e^x for any number: underflows to 0 and overflows to infinity where a float does.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> exponential_of(Doubles<n> x) {
  const Doubles<n> doublings = bounded<n>(x, -104, 89) * 1.44269504088896338700;  // 1 / ln 2
  const Doubles<n> shifted = doublings + rounder, whole = shifted - rounder;
  // 2^whole is added to the exponent. (It is 0 for NaN, whose low bits are 0.)
  return from_bits<n>(bits_of<n>(polynomial<n, exponential_series>(doublings - whole)) + (bits_of<n>(shifted) << 52));
}

/// ln((1 + f) / (1 - f)) / f for |f| <= (sqrt(2) - 1) / (sqrt(2) + 1), of f^2.
constexpr double logarithm_series[] = {2.0,
                                       0.6666666666666208,
                                       0.40000000011206566,
                                       0.28571424138306084,
                                       0.2222286228207592,
                                       0.18140193716866942,
                                       0.16621818452225706};

/// ln(x) for positive normal doubles.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> logarithm_of(Doubles<n> x) {
  const Bits<n> bits = bits_of<n>(x);
  // The mantissa from sqrt(1/2) to sqrt(2), and its exponent.
  const Bits<n> offset = bits - 0x3fe6a09e667f3bcdULL;
  const Bits<n> exponent_bits = offset & ~0xfffffffffffffULL;
  const Doubles<n> mantissa = from_bits<n>(bits - exponent_bits);
  const Doubles<n> exponent = from_bits<n>(((exponent_bits >> 52) & 0xfff) ^ 0x4338000000000800ULL) - (rounder + 0x800);
  const Doubles<n> f = (mantissa - 1) / (mantissa + 1);
  return exponent * 0.69314718055994530942 + f * polynomial<n, logarithm_series>(f * f);
}

template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> logarithm_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  const Doubles<n> other = choose(x == 0.0, all<n>(-infinite), choose(x > 0.0, x, all<n>(not_a_number)));
  return rounded<n>(choose((x > 0.0) & (x < infinite), logarithm_of<n>(x), other));
}

/// atan(t) / t for |t| <= tan(pi / 8), of t^2.
constexpr double arctangent_series[] = {1.0,
                                        -0.3333333333333093,
                                        0.1999999999772487,
                                        -0.142857139303763,
                                        0.11111089649095444,
                                        -0.09090255949815608,
                                        0.07681045164160165,
                                        -0.06550907022268446,
                                        0.05168833842575298,
                                        -0.027232867108164412};

/// atan(above / below) for numbers that are not negative; one may be 0 or infinite.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> arctangent_of(Doubles<n> above, Doubles<n> below) {
  // Addition theorem of tan: the result is base + atan(t) with |t| <= tan(pi / 8).
  constexpr double eighth = 0.41421356237309503, three_eighths = 2.41421356237309492;
  const auto large = above > below * three_eighths, middle = above > below * eighth;
  const Doubles<n> base = choose(large, all<n>(half_pi), choose(middle, all<n>(0.78539816339744827900), Doubles<n>{}));
  const Doubles<n> t_above = choose(large, -below, choose(middle, above - below, above));
  const Doubles<n> t_below = choose(large, above, choose(middle, above + below, below));
  const Doubles<n> t = t_above / t_below;
  return base + t * polynomial<n, arctangent_series>(t * t);
}

template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> arctangent_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  return rounded<n>(with_sign_of<n>(arctangent_of<n>(magnitude_of<n>(x), all<n>(1)), x));
}

template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> arctangent2_in_lanes(Floats<n> y, Floats<n> x) {
  // Infinite arguments count as far larger than all floats, so that their quotient is 1.
  constexpr double far = 1e100;
  const Doubles<n> wide_y = widened<n>(y), wide_x = widened<n>(x);
  const Doubles<n> y_size = magnitude_of<n>(wide_y), x_size = magnitude_of<n>(wide_x);
  const Doubles<n> above = choose(y_size > far, all<n>(far), y_size), size = choose(x_size > far, all<n>(far), x_size);
  const Doubles<n> below = choose((above == 0.0) & (size == 0.0), all<n>(1), size);
  const Doubles<n> angle = arctangent_of<n>(above, below);
  const Bits<n> left = -(bits_of<n>(wide_x) >> 63);  // all bits set if x is negative
  const Bits<n> chosen = (bits_of<n>(2 * half_pi - angle) & left) | (bits_of<n>(angle) & ~left);
  return rounded<n>(with_sign_of<n>(from_bits<n>(chosen & ~sign_bit), wide_y));
}

/// asin(x) / x for |x| <= 1/2, of x^2.
constexpr double arcsine_series[] = {1.0,
                                     0.1666666666666218,
                                     0.07500000003584595,
                                     0.044642852437894766,
                                     0.030382182778197812,
                                     0.02236606589432528,
                                     0.01744149624342553,
                                     0.01318791205729391,
                                     0.01567567982271797,
                                     -0.002939832274133494,
                                     0.027907068622609634};

/// asin(size) for 0 <= size <= 1: `angle`, or pi / 2 - `angle` if `steep`, by asin(x) = pi / 2 - 2 asin(sqrt((1 - x) /
/// 2)).
template <std::size_t n>
struct Arcsine {
  Doubles<n> angle;
  decltype(Doubles<n>{} > Doubles<n>{}) steep;
};
template <std::size_t n>
[[gnu::always_inline]] inline Arcsine<n> arcsine_of(Doubles<n> size) {
  const auto steep = size > 0.5;
  const Doubles<n> square = choose(steep, (1 - size) * 0.5, size * size);
  const Doubles<n> root = choose(steep, 2 * square_root_of<n>(square), size);
  return {root * polynomial<n, arcsine_series>(square), steep};
}

template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> arcsine_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  const auto [angle, steep] = arcsine_of<n>(magnitude_of<n>(x));
  return rounded<n>(with_sign_of<n>(choose(steep, half_pi - angle, angle), x));
}

template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> arccosine_in_lanes(Floats<n> argument) {
  const Doubles<n> x = widened<n>(argument);
  const auto [angle, steep] = arcsine_of<n>(magnitude_of<n>(x));
  const Doubles<n> other = choose(x < 0.0, 2 * half_pi - angle, angle);
  return rounded<n>(choose(steep, other, half_pi - with_sign_of<n>(angle, x)));
}

/// a^b with the special cases of C's pow(): 1 if b is 0 or a is 1, even if the other is NaN.
template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> power_in_lanes(Floats<n> base, Floats<n> exponent) {
  const Doubles<n> a = widened<n>(base), b = widened<n>(exponent), size = magnitude_of<n>(a);
  const Doubles<n> logarithm =
      choose(size == 0.0, all<n>(-infinite), choose(size < infinite, logarithm_of<n>(size), size));
  // The powers of 1 and -1 have the size 1, those to infinity too.
  const Doubles<n> product = choose(size == 1.0, Doubles<n>{}, b * logarithm);
  const Doubles<n> power = exponential_of<n>(product);
  // A whole number, and whether it is odd. Floats from 2^24 on are even.
  constexpr double even = 33554432.0;
  const Doubles<n> b_size = magnitude_of<n>(b), small = choose(b_size > even, all<n>(even), b_size);
  const Doubles<n> shifted = small + rounder;
  const Bits<n> odd = -(bits_of<n>(shifted) & 1);
  const auto fraction = shifted - rounder != small;
  const auto negative = (a < 0.0) & (a > -infinite);
  const Bits<n> sign = bits_of<n>(a) & sign_bit & choose(fraction, Bits<n>{}, odd);
  const Doubles<n> number = choose(negative & fraction, all<n>(not_a_number), from_bits<n>(bits_of<n>(power) ^ sign));
  const Doubles<n> result = choose((a == a) & (b == b), number, all<n>(not_a_number));
  return rounded<n>(choose((a == 1.0) | (b == 0.0), all<n>(1), result));
}

/// How far ends of intervals are moved outwards, relative to their size and beyond that: the functions are accurate to
/// about one ulp and nearly, but not provably, monotone; four ulps are a safe margin.
constexpr float function_margin = 6e-7F, function_slack = 1e-44F, largest_float = 3.402823466e38F;

/// Whether an operation is one of these functions.
constexpr bool is_function(Opcode op) {
  switch (op) {
    case Opcode::sine:
    case Opcode::cosine:
    case Opcode::tangent:
    case Opcode::arcsine:
    case Opcode::arccosine:
    case Opcode::arctangent:
    case Opcode::exponential:
    case Opcode::logarithm:
    case Opcode::power:
    case Opcode::arctangent2: return true;
    default: return false;
  }
}

/// Whether an operation is defined by the C library for arguments beyond wave_limit.
constexpr bool is_wave(Opcode op) { return op == Opcode::sine || op == Opcode::cosine || op == Opcode::tangent; }
inline bool wave_is_near(float a) { return __builtin_fabsf(a) <= wave_limit; }

/// The functions by operation; waves for arguments that are near.
template <Opcode op, std::size_t n>
[[gnu::always_inline]] inline Floats<n> function_in_lanes(Floats<n> a, [[maybe_unused]] Floats<n> b) {
  if constexpr (op == Opcode::sine) return sine_in_lanes<n, false>(a);
  if constexpr (op == Opcode::cosine) return sine_in_lanes<n, true>(a);
  if constexpr (op == Opcode::tangent) return tangent_in_lanes<n>(a);
  if constexpr (op == Opcode::arcsine) return arcsine_in_lanes<n>(a);
  if constexpr (op == Opcode::arccosine) return arccosine_in_lanes<n>(a);
  if constexpr (op == Opcode::arctangent) return arctangent_in_lanes<n>(a);
  if constexpr (op == Opcode::exponential) return rounded<n>(exponential_of<n>(widened<n>(a)));
  if constexpr (op == Opcode::logarithm) return logarithm_in_lanes<n>(a);
  if constexpr (op == Opcode::power) return power_in_lanes<n>(a, b);
  if constexpr (op == Opcode::arctangent2) return arctangent2_in_lanes<n>(a, b);
}

}  // namespace
}  // namespace fieldfab::frep
