// Difference quotients over a box, one direction per lane: forward differentiation in interval
// arithmetic. Each rule holds for differences between any two points of the box, not only for
// derivatives, so that min, max and abs need no special treatment.
#include "slopes.h"

#include <array>
#include <cmath>
#include <cstring>

#include "fieldfab/frep/reference.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

/// Four lanes: each processor has registers of that size.
using Four = float __attribute__((vector_size(16)));
constexpr std::size_t fours = slope_lanes / 4;

Four least(Four a, Four b) { return a < b ? a : b; }
Four greatest(Four a, Four b) { return a > b ? a : b; }

/// Slopes of one value, one direction per lane. If `known` is false, the numbers are invalid.
struct Lanes {
  Four lower[fours], upper[fours];
  bool known;
};

constexpr Lanes none{{}, {}, true};  // of a constant

void set_unknown(Lanes& out) { out.known = false; }

void set_negated(Lanes& out, const Lanes& a) {
  for (std::size_t i = 0; i < fours; ++i) {
    const Four lower = -a.upper[i], upper = -a.lower[i];
    out.lower[i] = lower, out.upper[i] = upper;
  }
  out.known = a.known;
}

void set_sum(Lanes& out, const Lanes& a, const Lanes& b) {
  for (std::size_t i = 0; i < fours; ++i)
    out.lower[i] = a.lower[i] + b.lower[i], out.upper[i] = a.upper[i] + b.upper[i];
  out.known = a.known && b.known;
}

void set_difference(Lanes& out, const Lanes& a, const Lanes& b) {
  for (std::size_t i = 0; i < fours; ++i)
    out.lower[i] = a.lower[i] - b.upper[i], out.upper[i] = a.upper[i] - b.lower[i];
  out.known = a.known && b.known;
}

void set_hull(Lanes& out, const Lanes& a, const Lanes& b) {
  for (std::size_t i = 0; i < fours; ++i)
    out.lower[i] = least(a.lower[i], b.lower[i]), out.upper[i] = greatest(a.upper[i], b.upper[i]);
  out.known = a.known && b.known;
}

void set_scaled(Lanes& out, const Interval& by, const Lanes& a) {
  const float low = by.lower, high = by.upper;
  for (std::size_t i = 0; i < fours; ++i) {
    const Four ll = low * a.lower[i], lu = low * a.upper[i], ul = high * a.lower[i], uu = high * a.upper[i];
    out.lower[i] = least(least(ll, lu), least(ul, uu));
    out.upper[i] = greatest(greatest(ll, lu), greatest(ul, uu));
  }
  out.known = a.known && !by.maybe_nan && std::isfinite(low) && std::isfinite(high);
}

Lanes scaled(const Interval& by, const Lanes& a) {
  Lanes out;
  set_scaled(out, by, a);
  return out;
}

/// Whether all ends are finite: the difference of a number with itself is 0 except for infinities
/// and NaN.
bool is_finite(const Lanes& a) {
  Four off{};
  for (std::size_t i = 0; i < fours; ++i) off += (a.lower[i] - a.lower[i]) + (a.upper[i] - a.upper[i]);
  std::array<std::uint64_t, 2> bits;
  std::memcpy(bits.data(), &off, sizeof off);
  return (bits[0] | bits[1]) == 0;
}

/// Whether all slopes are known to be 0.
bool never_changes(const Lanes& a) {
  Four off{};
  for (std::size_t i = 0; i < fours; ++i) off += greatest(a.lower[i], -a.lower[i]) + greatest(a.upper[i], -a.upper[i]);
  return a.known && off[0] + off[1] + off[2] + off[3] == 0;
}

Interval inverse(const Interval& a) {
  if (has_zero(a)) return Interval::unknown();
  return {1 / a.upper, 1 / a.lower, a.maybe_nan};
}

Interval of_root(const Interval& a) { return {std::sqrt(std::max(a.lower, 0.0F)), std::sqrt(a.upper), a.maybe_nan}; }

/// a / sqrt(a^2 + rest), for `rest` >= 0: a sine, monotone in a.
Interval share_of_length(const Interval& a, const Interval& rest) {
  const auto share = [&](float number, bool least) {
    const float other = (number < 0) == least ? rest.lower : rest.upper;
    const float length = std::sqrt(number * number + other);
    return length > 0 ? number / length : number == 0 && other > 0 ? 0.0F : least ? -1.0F : 1.0F;
  };
  // 0 / 0 can be any number from -1 to 1.
  if (has_zero(a) && rest.lower <= 0) return {a.lower < 0 ? -1.0F : 0.0F, a.upper > 0 ? 1.0F : 0.0F, false};
  return {share(a.lower, true), share(a.upper, false), false};
}

class SlopeRun {
 public:
  SlopeRun(const Tape& tape, const Ranges& ranges, std::span<const Vec3> directions) : tape_(tape), ranges_(ranges) {
    static thread_local std::vector<Lanes> kept;
    if (kept.size() < first_value + tape.code.size()) kept.resize(first_value + tape.code.size());
    slopes_ = kept.data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      slopes_[axis] = none;
      for (std::size_t i = 0; i < directions.size(); ++i)
        slopes_[axis].lower[i / 4][i % 4] = static_cast<float>(directions[i][static_cast<Eigen::Index>(axis)]);
      std::copy_n(slopes_[axis].lower, fours, slopes_[axis].upper);
    }
  }

  const Lanes& run() {
    for (std::size_t i = 0; i < tape_.code.size(); ++i) {
      Lanes& made = slopes_[first_value + i];
      if (ranges_.maybe_nan[first_value + i] != 0)
        set_unknown(made);
      else
        step(tape_.code[i], first_value + i, made);
      // An infinite end would invalidate later results.
      if (made.known && !is_finite(made)) set_unknown(made);
    }
    return slopes_of(tape_.root);
  }

 private:
  [[nodiscard]] Interval range_of(Operand operand) const {
    return is_constant(operand) ? Interval::of(tape_.constants[operand & ~constant_bit]) : ranges_[operand];
  }
  [[nodiscard]] const Lanes& slopes_of(Operand operand) const { return is_constant(operand) ? none : slopes_[operand]; }

  void step(const Clause& clause, std::size_t place, Lanes& out) const {
    const Lanes& da = slopes_of(clause.a);
    if (arity(clause.op) == 2) return step_of_two(clause, place, da, slopes_of(clause.b), out);
    const Interval a = range_of(clause.a), value = ranges_[place];
    switch (clause.op) {
      case Opcode::sine: return set_scaled(out, apply(Opcode::cosine, a), da);
      case Opcode::cosine: return set_scaled(out, negate(apply(Opcode::sine, a)), da);
      case Opcode::tangent: return set_scaled(out, add(Interval::of(1), square(value), false), da);
      case Opcode::arcsine:
      case Opcode::arccosine: {
        if (a.lower <= -1 || a.upper >= 1) return set_unknown(out);
        const Interval slope = inverse(of_root(add(Interval::of(1), negate(square(a)), false)));
        return set_scaled(out, clause.op == Opcode::arcsine ? slope : negate(slope), da);
      }
      case Opcode::arctangent: return set_scaled(out, inverse(add(Interval::of(1), square(a), false)), da);
      case Opcode::absolute:
        if (a.lower >= 0) return void(out = da);
        set_negated(out, da);
        if (a.upper > 0) set_hull(out, out, da);
        return;
      case Opcode::square: return set_scaled(out, {2 * a.lower, 2 * a.upper, false}, da);
      case Opcode::square_root: return root(clause.a, value, da, out);
      case Opcode::negate: return set_negated(out, da);
      case Opcode::exponential: return set_scaled(out, value, da);
      case Opcode::logarithm: return set_scaled(out, inverse(a), da);
      case Opcode::floor:
      case Opcode::ceiling: return value.lower == value.upper ? void(out = none) : set_unknown(out);
      default: return set_unknown(out);
    }
  }

  void step_of_two(const Clause& clause, std::size_t place, const Lanes& da, const Lanes& db, Lanes& out) const {
    if (clause.op == Opcode::add) return set_sum(out, da, db);
    if (clause.op == Opcode::subtract) return set_difference(out, da, db);
    const Interval a = range_of(clause.a), b = range_of(clause.b);
    switch (clause.op) {
      case Opcode::multiply:
        if (clause.a == clause.b) return set_scaled(out, {2 * a.lower, 2 * a.upper, false}, da);
        if (is_constant(clause.a)) return set_scaled(out, a, db);
        set_scaled(out, b, da);
        if (!is_constant(clause.b)) set_sum(out, out, scaled(a, db));
        return;
      case Opcode::divide: {
        if (is_constant(clause.b)) return set_scaled(out, inverse(b), da);
        Lanes sum;
        set_sum(sum, da, scaled(negate(ranges_[place]), db));
        return set_scaled(out, inverse(b), sum);
      }
      case Opcode::minimum:
        if (a.upper <= b.lower) return void(out = da);
        return b.upper < a.lower ? void(out = db) : set_hull(out, da, db);
      case Opcode::maximum:
        if (a.lower >= b.upper) return void(out = da);
        return b.lower > a.upper ? void(out = db) : set_hull(out, da, db);
      case Opcode::power: {
        const Interval by_a = multiply(b, apply(Opcode::power, a, add(b, Interval::of(-1), false)), false);
        set_scaled(out, by_a, da);
        if (b.lower == b.upper) return;
        if (!(a.lower > 0)) return set_unknown(out);
        return set_sum(out, out, scaled(multiply(ranges_[place], apply(Opcode::logarithm, a, a), false), db));
      }
      case Opcode::arctangent2: {
        if (!(b.lower > 0 || a.lower > 0 || a.upper < 0)) return set_unknown(out);  // the cut, or the origin
        const Interval length = inverse(add(square(a), square(b), false));
        set_scaled(out, multiply(b, length, false), da);
        return set_sum(out, out, scaled(negate(multiply(a, length, false)), db));
      }
      case Opcode::modulo: {
        const Interval quotient = apply(Opcode::divide, a, b);
        const float whole = std::floor(quotient.lower);
        if (quotient.maybe_nan || whole != std::floor(quotient.upper)) return set_unknown(out);
        return set_sum(out, da, scaled(Interval::of(-whole), db));
      }
      case Opcode::compare: {
        const Interval value = ranges_[place];
        return value.lower == value.upper ? void(out = none) : set_unknown(out);
      }
      default: return set_unknown(out);
    }
  }

  /// The square root of a sum of squares is a length. Its slope is the sum over the parts of the
  /// part's slope times the part's share of the length, which is at most 1 even if the length is 0.
  /// Other roots have known slopes away from 0.
  void root(Operand argument, const Interval& value, const Lanes& slopes, Lanes& out) const {
    std::array<Operand, 4> parts;
    std::size_t count = 0;
    if (!squares_in(argument, parts, count)) {
      if (never_changes(slopes)) {
        out = none;
        return;
      }
      if (value.lower <= 0) return set_unknown(out);
      return set_scaled(out, inverse({2 * value.lower, 2 * value.upper, false}), slopes);
    }
    std::array<Interval, 4> range;
    for (std::size_t i = 0; i < count; ++i) range[i] = range_of(parts[i]);
    Four squares[fours] = {};
    out = none;
    for (std::size_t i = 0; i < count; ++i) {
      Interval rest = Interval::of(0);
      for (std::size_t j = 0; j < count; ++j)
        if (j != i) rest = add(rest, square(range[j]), false);
      const Lanes& part = slopes_of(parts[i]);
      set_sum(out, out, scaled(share_of_length(range[i], rest), part));
      for (std::size_t k = 0; k < fours; ++k) {
        const Four most = greatest(-part.lower[k], part.upper[k]);
        squares[k] += most * most;
      }
    }
    for (std::size_t k = 0; k < fours; ++k) {  // a length changes by at most the movement of its end
      Four most;
      for (int lane = 0; lane < 4; ++lane) most[lane] = std::sqrt(squares[k][lane]) * (1 + 1e-6F);
      out.lower[k] = greatest(out.lower[k], -most), out.upper[k] = least(out.upper[k], most);
    }
  }

  /// Whether a value is a square or a sum of two to four squares; `parts` gets the operands of the
  /// squares.
  bool squares_in(Operand operand, std::array<Operand, 4>& parts, std::size_t& count) const {
    if (!is_made(operand)) return false;
    const Clause& clause = tape_.code[operand - first_value];
    if (clause.op == Opcode::square || (clause.op == Opcode::multiply && clause.a == clause.b)) {
      if (count == parts.size()) return false;
      parts[count++] = clause.a;
      return true;
    }
    return clause.op == Opcode::add && squares_in(clause.a, parts, count) && squares_in(clause.b, parts, count);
  }

  const Tape& tape_;
  const Ranges& ranges_;
  Lanes* slopes_;
};

}  // namespace

void evaluate_slopes(const Tape& tape, const Ranges& ranges, std::span<const Vec3> directions,
                     std::span<Interval> out) {
  SlopeRun run(tape, ranges, directions);
  const Lanes& found = run.run();
  for (std::size_t i = 0; i < directions.size(); ++i)
    out[i] = found.known ? Interval{found.lower[i / 4][i % 4], found.upper[i / 4][i % 4], false} : Interval::unknown();
}

}  // namespace fieldfab::frep
