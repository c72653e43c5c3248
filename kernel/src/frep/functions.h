// sin, cos, exp, ln and atan in single precision, computed in double precision without branches, so
// that loops over them are vectorised. They are the definition: the reference evaluator and the
// batch evaluators of all instruction sets share this text, so that results have the same bits.
// Each result is the nearest float, or in about one case of a million its neighbour: the argument
// is reduced to a small range, and a Taylor series is accurate to 1e-12 there.
//
// Internal linkage on purpose: each instruction set compiles its own copy.
#pragma once

#include <cstdint>

namespace fieldfab::frep {
namespace {

inline std::uint64_t bits_of(double value) { return __builtin_bit_cast(std::uint64_t, value); }
inline double from_bits(std::uint64_t bits) { return __builtin_bit_cast(double, bits); }

/// Addition and subtraction of this number round to a whole number, which is in the low bits of the
/// sum.
constexpr double rounder = 6755399441055744.0;  // 1.5 * 2^52

/// Arguments of sine and cosine up to this size; the C library handles larger ones.
constexpr float wave_limit = 1e6F;

/// sin(x + quarter * pi / 2) for |x| <= wave_limit.
inline float wave_kernel(float argument, std::uint64_t quarter) {
  const double x = argument;
  const double shifted = x * 0.63661977236758134308 + rounder;  // 2 / pi
  const double turns = shifted - rounder;
  const std::uint64_t quadrant = bits_of(shifted) + quarter;
  // Range reduction of Cody and Waite (1980) with pi / 2 in two parts: the first has trailing zeros, so that its
  // product with a small whole number is exact.
  const double r = (x - turns * 1.57079632673412561417e+00) - turns * 6.07710050650619224932e-11;
  const double s = r * r;
  const double sine =
      r *
      (1 - s * (1 / 6.0) *
               (1 - s * (1 / 20.0) *
                        (1 - s * (1 / 42.0) * (1 - s * (1 / 72.0) * (1 - s * (1 / 110.0) * (1 - s * (1 / 156.0)))))));
  const double cosine =
      1 - s * 0.5 *
              (1 - s * (1 / 12.0) *
                       (1 - s * (1 / 30.0) * (1 - s * (1 / 56.0) * (1 - s * (1 / 90.0) * (1 - s * (1 / 132.0))))));
  const std::uint64_t odd = -(quadrant & 1);
  const std::uint64_t chosen = (bits_of(cosine) & odd) | (bits_of(sine) & ~odd);
  return static_cast<float>(from_bits(chosen ^ ((quadrant & 2) << 62)));
}

/// e^x for any number: underflows to 0 and overflows to infinity.
inline float exponential_kernel(float argument) {
  const double bounded = argument > 89 ? 89.0 : argument < -104 ? -104.0 : static_cast<double>(argument);
  const double shifted = bounded * 1.44269504088896338700 + rounder;  // 1 / ln 2
  const double whole = shifted - rounder;
  const double r = (bounded - whole * 0.693147180369123816490) - whole * 1.90821492927058770002e-10;
  double power = 1;
  for (int term = 11; term > 0; --term) power = 1 + power * r * (1.0 / term);
  const double scale = from_bits((bits_of(shifted) + 1023) << 52);
  return static_cast<float>(power * scale);
}

/// atan(x) for any number.
inline float arctangent_kernel(float argument) {
  const double x = argument, size = __builtin_fabs(x);
  // Addition theorem of tan: atan(size) = base + atan(t) with |t| <= tan(pi / 8).
  constexpr double eighth = 0.41421356237309503, three_eighths = 2.41421356237309492;
  const bool large = size > three_eighths, middle = size > eighth;
  const double base = large ? 1.57079632679489655800 : middle ? 0.78539816339744827900 : 0.0;
  const double above = large ? -1.0 : middle ? size - 1 : size, below = large ? size : middle ? size + 1 : 1.0;
  const double t = above / below, s = t * t;
  double series = 0;
  for (int odd = 29; odd > 0; odd -= 2) series = 1.0 / odd - s * series;
  return static_cast<float>(__builtin_copysign(base + t * series, x));
}

/// ln(x) for positive normal numbers; the C library handles the others.
inline float logarithm_kernel(float argument) {
  const std::uint64_t bits = bits_of(static_cast<double>(argument));
  // The mantissa from sqrt(1/2) to sqrt(2), and its exponent.
  const std::uint64_t offset = bits - 0x3fe6a09e667f3bcdULL;
  const std::uint64_t exponent_bits = offset & ~0xfffffffffffffULL;
  const double mantissa = from_bits(bits - exponent_bits);
  const double exponent = from_bits(((exponent_bits >> 52) & 0xfff) ^ 0x4338000000000800ULL) - (rounder + 0x800);
  const double f = (mantissa - 1) / (mantissa + 1), s = f * f;  // ln m = 2 atanh f
  double series = 0;
  for (int odd = 17; odd > 0; odd -= 2) series = 1.0 / odd + s * series;
  return static_cast<float>(exponent * 0.69314718055994530942 + 2 * f * series);
}
constexpr float smallest_normal = 1.17549435e-38F;

/// Whether a kernel holds for this argument.
inline bool wave_is_near(float a) { return __builtin_fabsf(a) <= wave_limit; }
inline bool is_positive_normal(float a) { return a >= smallest_normal && a <= 3.402823466e38F; }

}  // namespace
}  // namespace fieldfab::frep
