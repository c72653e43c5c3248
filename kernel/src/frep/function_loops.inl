// Loops over the functions of functions.h, as many lanes at a time as a vector of doubles has.
// Included by batch_loops.inl.
#include <utility>

#include "batch.h"
#include "functions.h"

namespace fieldfab::frep {
namespace {

#if defined(__AVX512DQ__)
constexpr std::size_t double_lanes = 8;
#elif defined(__AVX2__)
constexpr std::size_t double_lanes = 4;
#else
constexpr std::size_t double_lanes = 2;
#endif
/// Lanes of machine code, and of intervals: floats of one vector.
constexpr std::size_t float_lanes = 2 * double_lanes;

using LaneFloats = Floats<double_lanes>;
using Vector = Floats<float_lanes>;

inline Vector load(const float* from) {
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}
inline void store(float* to, Vector vector) { __builtin_memcpy(to, &vector, sizeof vector); }

using Words = std::uint32_t __attribute__((vector_size(float_lanes * 4)));
using Mask = decltype(Vector{} < Vector{});

/// Returns one bit for each lane of a comparison.
inline std::uint32_t lanes_of(Mask mask) {
#if defined(__AVX512DQ__)
  return static_cast<std::uint32_t>(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)));
#elif defined(__AVX2__)
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__SSE2__)
  return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < float_lanes; ++i) bits |= static_cast<std::uint32_t>(mask[i] != 0) << i;
  return bits;
#endif
}

/// A function of functions.h; waves for arguments that are near.
template <Opcode op>
[[gnu::always_inline]] inline Vector value_of(Vector a, Vector b) {
  constexpr std::size_t n = double_lanes;
  return joined<n>(function_in_lanes<op, n>(lower_half<n>(a), lower_half<n>(b)),
                   function_in_lanes<op, n>(upper_half<n>(a), upper_half<n>(b)));
}

/// Replaces the results of arguments beyond wave_limit, which are rare.
template <Opcode op>
[[gnu::noinline]] void mend_some(const Vector& in, std::uint32_t lanes, Vector& out) {
  for (std::size_t i = 0; i < float_lanes; ++i)
    if ((lanes >> i & 1U) != 0) out[i] = apply(op, in[i]);
}
template <Opcode op>
[[gnu::always_inline]] inline void mend_far_waves(const Vector& in, Vector& out) {
  const std::uint32_t near = lanes_of((in <= wave_limit) & (in >= -wave_limit)), every = (1U << float_lanes) - 1;
  if (near == every) return;
  Vector mended = out;
  mend_some<op>(in, near ^ every, mended);
  out = mended;
}

/// out[i] = op(a[i], b[i]) for float_lanes numbers. `out` may be `a` or `b`.
template <Opcode op>
[[gnu::always_inline]] inline void run_lanes(const float* a, const float* b, float* out) {
  const Vector in = load(a);
  Vector made = value_of<op>(in, load(b));
  if constexpr (is_wave(op)) mend_far_waves<op>(in, made);
  store(out, made);
}

/// An argument of a function: an array that goes on, or float_lanes numbers again and again.
struct LaneArgument {
  const float* numbers;
  bool goes_on;
  [[nodiscard]] const float* at(std::size_t i) const { return goes_on ? numbers + i : numbers; }
};

/// The same for n numbers, whole vectors.
template <Opcode op>
[[gnu::noinline]] void run_vectors(LaneArgument a, LaneArgument b, float* out, std::size_t n) {
  for (std::size_t i = 0; i < n; i += float_lanes) run_lanes<op>(a.at(i), b.at(i), out + i);
}

template <Opcode op>
void run_function(LaneArgument a, LaneArgument b, float* out, std::size_t n) {
  const std::size_t whole = n / float_lanes * float_lanes, rest = n - whole;
  if (whole != 0) run_vectors<op>(a, b, out, whole);
  if (rest == 0) return;
  float a_rest[float_lanes] = {}, b_rest[float_lanes] = {};
  for (std::size_t i = 0; i < rest; ++i) a_rest[i] = a.at(whole)[i], b_rest[i] = b.at(whole)[i];
  run_vectors<op>({a_rest, true}, {b_rest, true}, a_rest, float_lanes);
  for (std::size_t i = 0; i < rest; ++i) out[whole + i] = a_rest[i];
}

#define FIELDFAB_EACH_FUNCTION(what)                                                                     \
  what(sine) what(cosine) what(tangent) what(arcsine) what(arccosine) what(arctangent) what(exponential) \
      what(logarithm) what(power) what(arctangent2)

/// Applies a function to n points.
void run_function(Opcode op, LaneArgument a, LaneArgument b, float* out, std::size_t n) {
#define FIELDFAB_CASE(name) \
  case Opcode::name: return run_function<Opcode::name>(a, b, out, n);
  switch (op) {
    FIELDFAB_EACH_FUNCTION(FIELDFAB_CASE)
    default: return;
  }
#undef FIELDFAB_CASE
}

/// Returns Family::run<op>.
template <class Family, std::size_t... number>
auto instance_of(Opcode op, std::index_sequence<number...> /*all*/) {
  constexpr decltype(&Family::template run<Opcode::constant>) table[] = {
      &Family::template run<static_cast<Opcode>(number)>...};
  return table[static_cast<std::size_t>(op)];
}
template <class Family>
auto instance_of(Opcode op) {
  return instance_of<Family>(op, std::make_index_sequence<opcode_count>());
}

}  // namespace
}  // namespace fieldfab::frep
