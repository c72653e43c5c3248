// Intervals over several boxes at once, one box per lane. Included after batch_loops.inl by the
// files compiled for each instruction set. core/interval.h explains why most are not widened.
namespace fieldfab::frep {
namespace {

constexpr std::size_t width = float_lanes;
inline Vector least(Vector a, Vector b) { return a < b ? a : b; }
inline Vector greatest(Vector a, Vector b) { return a > b ? a : b; }

struct Span {
  Vector lower, upper;
};

/// Records lanes whose intervals were not finite: the difference of the ends is infinite or NaN
/// there, which are the largest bit patterns.
class Wildness {
 public:
  void watch(const Span& span) {
    const Words distance = reinterpret_cast<Words>(span.upper - span.lower);
    largest_ = largest_ > distance ? largest_ : distance;
  }
  void watch(Mask wild) { largest_ |= reinterpret_cast<Words>(wild); }
  [[nodiscard]] Mask mask() const { return reinterpret_cast<Mask>(largest_ > 0x7f7fffffU); }
  [[nodiscard]] std::uint32_t lanes() const { return lanes_of(mask()); }

 private:
  Words largest_{};
};

inline Span product(const Span& a, const Span& b) {
  const Vector ll = a.lower * b.lower, lu = a.lower * b.upper, ul = a.upper * b.lower, uu = a.upper * b.upper;
  return {least(least(ll, lu), least(ul, uu)), greatest(greatest(ll, lu), greatest(ul, uu))};
}

inline Span quotient(const Span& a, const Span& b) {
  const Vector ll = a.lower / b.lower, lu = a.lower / b.upper, ul = a.upper / b.lower, uu = a.upper / b.upper;
  return {least(least(ll, lu), least(ul, uu)), greatest(greatest(ll, lu), greatest(ul, uu))};
}

/// Interval of |a|, or of its square, given the images of a's ends.
inline Span folded(const Span& a, Vector at_lower, Vector at_upper) {
  const Vector small = least(at_lower, at_upper);
  return {((a.lower <= 0) & (a.upper >= 0)) ? Vector{} : small, greatest(at_lower, at_upper)};
}

inline Vector magnitude(Vector a) { return reinterpret_cast<Vector>(reinterpret_cast<Words>(a) & 0x7fffffffU); }

inline Vector root_of(Vector a) {
#if defined(__AVX512DQ__)
  return reinterpret_cast<Vector>(_mm512_maskz_sqrt_ps(0xffff, reinterpret_cast<__m512>(a)));
#elif defined(__AVX2__)
  return reinterpret_cast<Vector>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a)));
#elif defined(__SSE2__)
  return reinterpret_cast<Vector>(_mm_sqrt_ps(reinterpret_cast<__m128>(a)));
#else
  for (std::size_t i = 0; i < width; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
#endif
}

}  // namespace
}  // namespace fieldfab::frep

#include "interval_functions.inl"

namespace fieldfab::frep {
namespace {

/// State that operations share in the lanes of one vector.
struct Lanes {
  Wildness& wild;
  std::uint32_t first, second;  ///< lanes in which an argument was chosen
};

inline Span run_span(const Clause& clause, const Span& a, const Span& b, bool by_sign, Lanes& lanes) {
  Span out;
  switch (clause.op) {
    case Opcode::minimum:
      lanes.first = lanes_of(a.upper <= b.lower), lanes.second = lanes_of(b.upper < a.lower);
      if (by_sign) lanes.first |= lanes_of(b.lower > 0), lanes.second |= lanes_of(a.lower > 0);
      return {least(a.lower, b.lower), least(a.upper, b.upper)};
    case Opcode::maximum:
      lanes.first = lanes_of(a.lower >= b.upper), lanes.second = lanes_of(b.lower > a.upper);
      if (by_sign) lanes.first |= lanes_of(b.upper < 0), lanes.second |= lanes_of(a.upper < 0);
      return {greatest(a.lower, b.lower), greatest(a.upper, b.upper)};
    case Opcode::absolute:
      lanes.first = lanes_of(a.lower > 0), lanes.second = lanes_of(a.upper < 0);
      return folded(a, magnitude(a.lower), magnitude(a.upper));
    case Opcode::negate: return {-a.upper, -a.lower};
    case Opcode::add: out = {a.lower + b.lower, a.upper + b.upper}; break;
    case Opcode::subtract: out = {a.lower - b.upper, a.upper - b.lower}; break;
    case Opcode::multiply:
      // The product of a value with itself is its square, with the same floats.
      out = clause.a == clause.b ? folded(a, a.lower * a.lower, a.upper * a.upper) : product(a, b);
      break;
    case Opcode::square: out = folded(a, a.lower * a.lower, a.upper * a.upper); break;
    case Opcode::square_root: lanes.wild.watch(a.lower < 0); return {root_of(a.lower), root_of(a.upper)};
    default:  // divide
      lanes.wild.watch((b.lower <= 0) & (b.upper >= 0));
      out = quotient(a, b);
  }
  lanes.wild.watch(out);
  return out;
}

constexpr bool in_vectors(Opcode op) {
  switch (op) {
    case Opcode::minimum:
    case Opcode::maximum:
    case Opcode::absolute:
    case Opcode::negate:
    case Opcode::add:
    case Opcode::subtract:
    case Opcode::multiply:
    case Opcode::square:
    case Opcode::square_root:
    case Opcode::divide: return true;
    default: return false;
  }
}

/// Applies an operation to float_lanes boxes; `marks` gets all bits set in wild lanes.
template <Opcode op>
void run_span_of(const float* a_lower, const float* a_upper, const float* b_lower, const float* b_upper, float* lower,
                 float* upper, float* marks) {
  if constexpr (is_function(op)) {
    run_function_span<op>(a_lower, a_upper, b_lower, b_upper, lower, upper, marks);
  } else {
    for (std::size_t i = 0; i < width; ++i) {
      float range[2];
      const bool finite = finite_interval(op, a_lower[i], a_upper[i], b_lower[i], b_upper[i], range);
      lower[i] = range[0], upper[i] = range[1];
      marks[i] = __builtin_bit_cast(float, finite ? 0U : ~0U);
    }
  }
}

/// The same for the operations that run_span() lacks.
std::uint32_t run_other(Opcode op, const LaneRanges& a, const LaneRanges& b, LaneRanges& out, std::size_t lanes) {
  std::uint32_t wild = 0;
  float marks[width];
  for (std::size_t at = 0; at < lanes; at += width) {
    const auto run = [&](auto* function) {
      function(a.lower + at, a.upper + at, b.lower + at, b.upper + at, out.lower + at, out.upper + at, marks);
    };
#define FIELDFAB_CASE(name) \
  case Opcode::name: run(run_span_of<Opcode::name>); break;
    switch (op) {
      FIELDFAB_EACH_FUNCTION(FIELDFAB_CASE)
      FIELDFAB_CASE(floor)
      FIELDFAB_CASE(ceiling)
      FIELDFAB_CASE(modulo)
      default: run(run_span_of<Opcode::compare>);
    }
#undef FIELDFAB_CASE
    wild |= lanes_of(reinterpret_cast<Mask>(load(marks))) << at;
  }
  return wild;
}

/// Intervals for machine code (see LaneOperation).
struct LaneInterval {
  template <Opcode op>
  static void run(const float* in, float* out) {
    run_span_of<op>(in, in + width, in + 2 * width, in + 3 * width, out, out + width, out + 2 * width);
  }
};
LaneOperation lane_interval(Opcode op) { return instance_of<LaneInterval>(op); }

std::uint32_t run_intervals(const IntervalRun& run, LaneRanges& root) {
  constexpr std::size_t most_parts = box_lanes / width;
  const std::size_t parts = (run.lanes + width - 1) / width;
  Wildness wild[most_parts];
  std::uint32_t wild_lanes = 0;
  LaneRanges a_space, b_space;
  const auto argument = [&](Operand operand, LaneRanges& space) -> const LaneRanges* {
    if (is_made(operand)) return run.scratch + run.code[operand - first_value].slot;
    if (!is_constant(operand)) return run.box + operand;
    const float number = run.constants[operand & ~constant_bit];
    if (number - number != 0) wild_lanes = ~0U;
    const Vector all = number - Vector{};
    for (std::size_t part = 0; part < parts; ++part)
      store(space.lower + part * width, all), store(space.upper + part * width, all);
    return &space;
  };
  for (std::size_t part = 0; part < parts; ++part)
    for (const LaneRanges& axis : run.box)
      wild[part].watch({load(axis.lower + part * width), load(axis.upper + part * width)});

  for (std::size_t i = 0; i < run.clauses; ++i) {
    const Clause& clause = run.code[i];
    const LaneRanges* a = argument(clause.a, a_space);
    const LaneRanges* b = clause.b == clause.a ? a : argument(clause.b, b_space);
    LaneRanges* out = run.scratch + clause.slot;
    if (!in_vectors(clause.op)) {
      wild_lanes |= run_other(clause.op, *a, *b, *out, parts * width);
      run.choices[i] = {0, 0};
      continue;
    }
    std::uint32_t first = 0, second = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t at = part * width;
      Lanes lanes{wild[part], 0, 0};
      const Span made =
          run_span(clause, {load(a->lower + at), load(a->upper + at)}, {load(b->lower + at), load(b->upper + at)},
                   run.occupancy && clause.only_sign_matters, lanes);
      store(out->lower + at, made.lower), store(out->upper + at, made.upper);
      first |= lanes.first << at, second |= lanes.second << at;
    }
    run.choices[i] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(second)};
  }
  root = *argument(run.root, a_space);
  for (std::size_t part = 0; part < parts; ++part) wild_lanes |= wild[part].lanes() << (part * width);
  return wild_lanes;
}

}  // namespace
}  // namespace fieldfab::frep
