/// Lanes: one text of a function for a single number and for vectors of numbers. Single and double
/// precision side by side, `n` of each; for n = 1 they are plain numbers, so that operators,
/// comparisons and choose() mean the same for all.
///
/// Internal linkage on purpose: each instruction set compiles its own copy.
#pragma once

#include <cstddef>
#include <cstdint>
#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace fieldfab::frep {
namespace {

template <std::size_t n>
struct LaneTypes {
  using Floats [[gnu::vector_size(n * sizeof(float))]] = float;
  using Doubles [[gnu::vector_size(n * sizeof(double))]] = double;
  using Bits [[gnu::vector_size(n * sizeof(double))]] = std::uint64_t;
};
template <>
struct LaneTypes<1> {
  using Floats = float;
  using Doubles = double;
  using Bits = std::uint64_t;
};
template <std::size_t n>
using Floats = typename LaneTypes<n>::Floats;
template <std::size_t n>
using Doubles = typename LaneTypes<n>::Doubles;
template <std::size_t n>
using Bits = typename LaneTypes<n>::Bits;

template <std::size_t n>
[[gnu::always_inline]] inline Bits<n> bits_of(Doubles<n> numbers) {
  return __builtin_bit_cast(Bits<n>, numbers);
}
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> from_bits(Bits<n> bits) {
  return __builtin_bit_cast(Doubles<n>, bits);
}

/// Returns doubles with the same values.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> widened(Floats<n> numbers) {
  if constexpr (n == 1) return numbers;
#if defined(__AVX512DQ__)  // GCC 12 converts halves and joins them
  else if constexpr (n == 8)
    return __builtin_bit_cast(Doubles<n>, _mm512_maskz_cvtps_pd(0xff, __builtin_bit_cast(__m256, numbers)));
#endif
#if defined(__AVX2__)
  else if constexpr (n == 4)
    return __builtin_bit_cast(Doubles<n>, _mm256_cvtps_pd(__builtin_bit_cast(__m128, numbers)));
#endif
  else
    return __builtin_convertvector(numbers, Doubles<n>);
}

/// Rounds to floats.
template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> rounded(Doubles<n> numbers) {
  if constexpr (n == 1)
    return static_cast<float>(numbers);
  else
    return __builtin_convertvector(numbers, Floats<n>);
}

/// Two vectors as one. (Not by way of memory: a processor waits where it loads what two stores wrote.)
template <std::size_t n>
[[gnu::always_inline]] inline Floats<2 * n> joined(Floats<n> low, Floats<n> high) {
  if constexpr (n == 2) return __builtin_shufflevector(low, high, 0, 1, 2, 3);
  if constexpr (n == 4) return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  if constexpr (n == 8) return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> lower_half(Floats<2 * n> whole) {
  if constexpr (n == 2) return __builtin_shufflevector(whole, whole, 0, 1);
  if constexpr (n == 4) return __builtin_shufflevector(whole, whole, 0, 1, 2, 3);
  if constexpr (n == 8) return __builtin_shufflevector(whole, whole, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <std::size_t n>
[[gnu::always_inline]] inline Floats<n> upper_half(Floats<2 * n> whole) {
  if constexpr (n == 2) return __builtin_shufflevector(whole, whole, 2, 3);
  if constexpr (n == 4) return __builtin_shufflevector(whole, whole, 4, 5, 6, 7);
  if constexpr (n == 8) return __builtin_shufflevector(whole, whole, 8, 9, 10, 11, 12, 13, 14, 15);
}

/// Returns a number that is not 0 in all lanes.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> all(double number) {
  return number + Doubles<n>{};
}

/// Returns `if_so` where a comparison holds, `if_not` elsewhere.
template <class Condition, class Number>
[[gnu::always_inline]] inline Number choose(Condition condition, Number if_so, Number if_not) {
  return condition ? if_so : if_not;
}

constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> magnitude_of(Doubles<n> numbers) {
  return from_bits<n>(bits_of<n>(numbers) & ~sign_bit);
}
/// Returns numbers that are not negative with the signs of others.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> with_sign_of(Doubles<n> sizes, Doubles<n> signs) {
  return from_bits<n>(bits_of<n>(sizes) | (bits_of<n>(signs) & sign_bit));
}

/// Square roots, correctly rounded; NaN for negative numbers.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> square_root_of(Doubles<n> numbers) {
  if constexpr (n == 1) return __builtin_sqrt(numbers);
#if defined(__AVX512DQ__)
  else if constexpr (n == 8)
    return __builtin_bit_cast(Doubles<n>, _mm512_maskz_sqrt_pd(0xff, __builtin_bit_cast(__m512d, numbers)));
#endif
#if defined(__AVX2__)
  else if constexpr (n == 4)
    return __builtin_bit_cast(Doubles<n>, _mm256_sqrt_pd(__builtin_bit_cast(__m256d, numbers)));
#endif
#if defined(__SSE2__)
  else if constexpr (n == 2)
    return __builtin_bit_cast(Doubles<n>, _mm_sqrt_pd(__builtin_bit_cast(__m128d, numbers)));
#endif
  else {
    for (std::size_t i = 0; i < n; ++i) numbers[i] = __builtin_sqrt(numbers[i]);
    return numbers;
  }
}

/// The nearest numbers from `low` to `high`; NaN stays.
template <std::size_t n>
[[gnu::always_inline]] inline Doubles<n> bounded(Doubles<n> x, double low, double high) {
  // Of these instructions the result is the second argument if either is NaN.
#if defined(__AVX512DQ__)
  if constexpr (n == 8) {
    const __m512d below = _mm512_maskz_min_pd(0xff, _mm512_set1_pd(high), __builtin_bit_cast(__m512d, x));
    return __builtin_bit_cast(Doubles<n>, _mm512_maskz_max_pd(0xff, _mm512_set1_pd(low), below));
  }
#endif
#if defined(__AVX2__)
  if constexpr (n == 4) {
    const __m256d below = _mm256_min_pd(_mm256_set1_pd(high), __builtin_bit_cast(__m256d, x));
    return __builtin_bit_cast(Doubles<n>, _mm256_max_pd(_mm256_set1_pd(low), below));
  }
#endif
#if defined(__SSE2__)
  if constexpr (n == 2) {
    const __m128d below = _mm_min_pd(_mm_set1_pd(high), __builtin_bit_cast(__m128d, x));
    return __builtin_bit_cast(Doubles<n>, _mm_max_pd(_mm_set1_pd(low), below));
  }
#endif
  return choose(x > high, all<n>(high), choose(x < low, all<n>(low), x));
}

}  // namespace
}  // namespace fieldfab::frep
