// Intervals of the functions of functions.h, one box per lane: the same ends as apply() of
// interval.cpp. Lanes where an end is not finite or a value may be NaN are marked wild. Included by
// interval_loops.inl.

namespace fieldfab::frep {
namespace {

static_assert(width == float_lanes);

inline Vector all_of(float number) { return number - Vector{}; }

/// Widens an interval by the inaccuracy of the functions.
inline Span loosened(const Span& a, Wildness& wild) {
  const Vector largest = all_of(largest_float);
  wild.watch((a.lower != a.lower) | (a.upper != a.upper));
  const Vector below = least(magnitude(a.lower), largest) * function_margin + function_slack;
  const Vector above = least(magnitude(a.upper), largest) * function_margin + function_slack;
  return {least(a.lower, largest) - below, greatest(a.upper, -largest) + above};
}

/// Interval of a function that grows, or falls, over its domain from `low` to `high`.
template <Opcode op, bool falls = false>
inline Span monotone_span(const Span& a, float low, float high, Wildness& wild) {
  wild.watch((a.lower < low) | (a.upper > high));
  const Vector at_lower = value_of<op>(a.lower, a.lower), at_upper = value_of<op>(a.upper, a.upper);
  return loosened(falls ? Span{at_upper, at_lower} : Span{at_lower, at_upper}, wild);
}

using LaneDoubles = Doubles<double_lanes>;

inline LaneDoubles floor_of(LaneDoubles x) {
  const LaneDoubles whole = (x + rounder) - rounder;
  return choose(whole > x, whole - 1, whole);
}
/// Calls count(lower, upper) with the ends as doubles, a half of the lanes at a time; returns its
/// numbers as floats.
template <class Count>
inline Vector in_doubles(const Span& a, const Count& count) {
  constexpr std::size_t n = double_lanes;
  return joined<n>(rounded<n>(count(widened<n>(lower_half<n>(a.lower)), widened<n>(lower_half<n>(a.upper)))),
                   rounded<n>(count(widened<n>(upper_half<n>(a.lower)), widened<n>(upper_half<n>(a.upper)))));
}

/// Sine or cosine: see wave() of interval.cpp, which has the same numbers.
template <Opcode op>
inline Span wave_span(const Span& a, Wildness& wild) {
  constexpr double pi = 3.14159265358979323846, phase = op == Opcode::sine ? 0 : pi / 2;
  constexpr double slack = 1e-9, turn = 1 / (2 * pi);
  const auto has_crest = [](double sign) {
    return [sign](LaneDoubles lower, LaneDoubles upper) {
      const LaneDoubles low = lower + phase, high = upper + phase;
      const LaneDoubles last = floor_of((high - sign * (pi / 2) + slack) * turn);
      const LaneDoubles before = floor_of((low - sign * (pi / 2) - slack) * turn);
      return choose(last > before, LaneDoubles{} + 1, LaneDoubles{});
    };
  };
  const Vector is_long = in_doubles(a, [](LaneDoubles lower, LaneDoubles upper) {
    return choose((upper + phase) - (lower + phase) >= 2 * pi, LaneDoubles{} + 1, LaneDoubles{});
  });
  const Vector one = value_of<op>(a.lower, a.lower), other = value_of<op>(a.upper, a.upper);
  const Vector up = all_of(1), down = all_of(-1);
  const Vector upper = in_doubles(a, has_crest(1)) > 0 ? up : greatest(one, other);
  const Vector lower = in_doubles(a, has_crest(-1)) > 0 ? down : least(one, other);
  const Mask near = (magnitude(a.lower) < 4096) & (magnitude(a.upper) < 4096) & (is_long <= 0);
  const Span wide = loosened({near ? lower : down, near ? upper : up}, wild);
  return {greatest(wide.lower, down), least(wide.upper, up)};
}

inline Span tangent_span(const Span& a, Wildness& wild) {
  constexpr double pi = 3.14159265358979323846, slack = 1e-6;
  const Vector has_pole = in_doubles(a, [](LaneDoubles lower, LaneDoubles upper) {
    const LaneDoubles last = floor_of((upper + pi / 2 + slack) / pi);
    return choose(last > floor_of((lower + pi / 2 - slack) / pi), LaneDoubles{} + 1, LaneDoubles{});
  });
  wild.watch((magnitude(a.lower) >= 4096) | (magnitude(a.upper) >= 4096) | (has_pole > 0));
  return monotone_span<Opcode::tangent>(a, -4096, 4096, wild);
}

/// The least and the greatest value at the four corners of a rectangle; wild where one is NaN.
template <Opcode op>
inline Span corners(const Span& a, const Span& b, Wildness& wild) {
  const Vector ll = value_of<op>(a.lower, b.lower), ul = value_of<op>(a.upper, b.lower);
  wild.watch((ll != ll) | (ul != ul));
  Span out{least(ll, ul), greatest(ll, ul)};
  if (lanes_of(b.lower != b.upper) != 0) {
    const Vector lu = value_of<op>(a.lower, b.upper), uu = value_of<op>(a.upper, b.upper);
    wild.watch((lu != lu) | (uu != uu));
    out = {least(out.lower, least(lu, uu)), greatest(out.upper, greatest(lu, uu))};
  }
  return out;
}

inline Mask contains(const Span& a, float number) { return (a.lower <= number) & (a.upper >= number); }
/// Whether floats up to 1e6 are whole numbers.
inline Mask is_whole(Vector a) {
  constexpr float float_rounder = 12582912;  // 1.5 * 2^23
  return (a + float_rounder) - float_rounder == a;
}

/// a^b: see power() of interval.cpp.
inline Span power_span(const Span& a, const Span& b, Wildness& wild) {
  const Vector zero{}, one = all_of(1);
  const Span at_corners = corners<Opcode::power>(a, b, wild);
  const Mask whole = (b.lower == b.upper) & (magnitude(b.lower) < 1e6F) & is_whole(b.lower);
  const Mask even = is_whole(b.lower * 0.5F), has_zero = contains(a, 0);
  wild.watch((whole & (b.lower < 0) & has_zero) | (~whole & ~(a.lower > 0)));
  const Mask has_one = ~whole & (contains(a, 1) | contains(b, 0));
  Span made{(whole & even & has_zero) ? zero : at_corners.lower, at_corners.upper};
  made = {has_one ? least(made.lower, one) : made.lower, has_one ? greatest(made.upper, one) : made.upper};
  made = loosened(made, wild);
  made.lower = (~whole | even) ? greatest(made.lower, zero) : made.lower;
  const Mask is_one = whole & (b.lower == 0);
  return {is_one ? one : made.lower, is_one ? one : made.upper};
}

/// atan2(y, x): see arctangent2() of interval.cpp.
inline Span arctangent2_span(const Span& y, const Span& x, Wildness& wild) {
  constexpr float pi = 3.1415927410125732F;
  const Span made = loosened(corners<Opcode::arctangent2>(y, x, wild), wild);
  const Mask one_branch = (x.lower > 0) | (y.lower > 0) | (y.upper < 0);
  return {one_branch ? made.lower : all_of(-pi), one_branch ? made.upper : all_of(pi)};
}

template <Opcode op>
[[gnu::always_inline]] inline Span function_span(const Span& a, [[maybe_unused]] const Span& b, Wildness& wild) {
  constexpr float infinity = __builtin_inff();
  if constexpr (op == Opcode::sine || op == Opcode::cosine) return wave_span<op>(a, wild);
  if constexpr (op == Opcode::tangent) return tangent_span(a, wild);
  if constexpr (op == Opcode::arcsine) return monotone_span<op>(a, -1, 1, wild);
  if constexpr (op == Opcode::arccosine) return monotone_span<op, true>(a, -1, 1, wild);
  if constexpr (op == Opcode::arctangent) return monotone_span<op>(a, -infinity, infinity, wild);
  if constexpr (op == Opcode::logarithm) return monotone_span<op>(a, 0, infinity, wild);
  if constexpr (op == Opcode::power) return power_span(a, b, wild);
  if constexpr (op == Opcode::arctangent2) return arctangent2_span(a, b, wild);
  if constexpr (op == Opcode::exponential) {
    const Span made = monotone_span<op>(a, -infinity, infinity, wild);
    return {greatest(made.lower, Vector{}), made.upper};
  }
}

/// The interval of op(a, b) from arrays of ends. `marks` gets all bits set in wild lanes.
template <Opcode op>
[[gnu::noinline]] void run_function_span(const float* a_lower, const float* a_upper, const float* b_lower,
                                         const float* b_upper, float* lower, float* upper, float* marks) {
  Wildness wild;
  const Span made = function_span<op>({load(a_lower), load(a_upper)}, {load(b_lower), load(b_upper)}, wild);
  wild.watch(made);
  store(lower, made.lower), store(upper, made.upper), store(marks, reinterpret_cast<Vector>(wild.mask()));
}

}  // namespace
}  // namespace fieldfab::frep
