// Difference quotients over a box, a direction a lane: forward differentiation in interval arithmetic. Each rule holds for
// differences between any two points of the box, not only for derivatives, so that min, max and abs need no special care.
#include "slopes.h"

#include <array>
#include <cmath>

#include "fieldfab/frep/reference.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

/// The slopes of one value, a direction a lane; `known` is false where nothing is known about them.
struct Lanes {
  float lower[slope_lanes];
  float upper[slope_lanes];
  bool known;
};

Lanes all(float number) {
  Lanes lanes;
  std::fill_n(lanes.lower, slope_lanes, number);
  std::fill_n(lanes.upper, slope_lanes, number);
  lanes.known = true;
  return lanes;
}

Lanes unknown() {
  Lanes lanes = all(0);
  lanes.known = false;
  return lanes;
}

Lanes negated(const Lanes& a) {
  Lanes out;
  for (std::size_t i = 0; i < slope_lanes; ++i) out.lower[i] = -a.upper[i], out.upper[i] = -a.lower[i];
  out.known = a.known;
  return out;
}

Lanes sum(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t i = 0; i < slope_lanes; ++i) out.lower[i] = a.lower[i] + b.lower[i], out.upper[i] = a.upper[i] + b.upper[i];
  out.known = a.known && b.known;
  return out;
}

Lanes hull(const Lanes& a, const Lanes& b) {
  Lanes out;
  for (std::size_t i = 0; i < slope_lanes; ++i) {
    out.lower[i] = a.lower[i] < b.lower[i] ? a.lower[i] : b.lower[i];
    out.upper[i] = a.upper[i] > b.upper[i] ? a.upper[i] : b.upper[i];
  }
  out.known = a.known && b.known;
  return out;
}

Lanes scaled(const Interval& by, const Lanes& a) {
  if (by.maybe_nan || !std::isfinite(by.lower) || !std::isfinite(by.upper)) return unknown();
  Lanes out;
  for (std::size_t i = 0; i < slope_lanes; ++i) {
    const float ll = by.lower * a.lower[i], lu = by.lower * a.upper[i], ul = by.upper * a.lower[i], uu = by.upper * a.upper[i];
    const float low = ll < lu ? ll : lu, lower = ul < uu ? ul : uu, high = ll > lu ? ll : lu, higher = ul > uu ? ul : uu;
    out.lower[i] = low < lower ? low : lower;
    out.upper[i] = high > higher ? high : higher;
  }
  out.known = a.known;
  return out;
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
    kept.resize(first_value + tape.code.size());
    slopes_ = kept.data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      slopes_[axis] = all(0);
      for (std::size_t i = 0; i < directions.size(); ++i)
        slopes_[axis].lower[i] = slopes_[axis].upper[i] = static_cast<float>(directions[i][static_cast<Eigen::Index>(axis)]);
    }
  }

  Lanes run() {
    for (std::size_t i = 0; i < tape_.code.size(); ++i) {
      Lanes& made = slopes_[first_value + i];
      const bool jumps = ranges_.maybe_nan[first_value + i] != 0;
      made = jumps ? unknown() : step(tape_.code[i], ranges_[first_value + i]);
      // An end that is not finite would spoil what is made of it.
      float largest = 0;
      for (std::size_t lane = 0; lane < slope_lanes; ++lane) largest += std::abs(made.lower[lane]) + std::abs(made.upper[lane]);
      if (!std::isfinite(largest)) made = unknown();
    }
    return slopes_of(tape_.root);
  }

 private:
  [[nodiscard]] Interval range_of(Operand operand) const {
    return is_constant(operand) ? Interval::of((*tape_.constants)[operand & ~constant_bit]) : ranges_[operand];
  }
  [[nodiscard]] Lanes slopes_of(Operand operand) const { return is_constant(operand) ? all(0) : slopes_[operand]; }

  [[nodiscard]] Lanes step(const Clause& clause, const Interval& value) const {
    const Interval a = range_of(clause.a), b = range_of(clause.b);
    const Lanes da = slopes_of(clause.a);
    if (arity(clause.op) == 2) return step_of_two(clause, value, a, b, da, slopes_of(clause.b));
    switch (clause.op) {
      case Opcode::sine: return scaled(apply(Opcode::cosine, a), da);
      case Opcode::cosine: return scaled(negate(apply(Opcode::sine, a)), da);
      case Opcode::tangent: return scaled(add(Interval::of(1), square(value), false), da);
      case Opcode::arcsine:
      case Opcode::arccosine: {
        const Interval slope = inverse(of_root(add(Interval::of(1), negate(square(a)), false)));
        if (a.lower <= -1 || a.upper >= 1) return unknown();
        return scaled(clause.op == Opcode::arcsine ? slope : negate(slope), da);
      }
      case Opcode::arctangent: return scaled(inverse(add(Interval::of(1), square(a), false)), da);
      case Opcode::absolute: return a.lower >= 0 ? da : a.upper <= 0 ? negated(da) : hull(da, negated(da));
      case Opcode::square: return scaled({2 * a.lower, 2 * a.upper, false}, da);
      case Opcode::square_root: return root(clause.a, value, da);
      case Opcode::negate: return negated(da);
      case Opcode::exponential: return scaled(value, da);
      case Opcode::logarithm: return scaled(inverse(a), da);
      case Opcode::floor:
      case Opcode::ceiling: return value.lower == value.upper ? all(0) : unknown();
      default: return unknown();
    }
  }

  [[nodiscard]] Lanes step_of_two(const Clause& clause, const Interval& value, const Interval& a, const Interval& b,
                                  const Lanes& da, const Lanes& db) const {
    switch (clause.op) {
      case Opcode::add: return sum(da, db);
      case Opcode::subtract: return sum(da, negated(db));
      case Opcode::multiply:
        if (clause.a == clause.b) return scaled({2 * a.lower, 2 * a.upper, false}, da);
        return sum(scaled(b, da), scaled(a, db));
      case Opcode::divide: return scaled(inverse(b), sum(da, scaled(negate(value), db)));
      case Opcode::minimum: return a.upper <= b.lower ? da : b.upper < a.lower ? db : hull(da, db);
      case Opcode::maximum: return a.lower >= b.upper ? da : b.lower > a.upper ? db : hull(da, db);
      case Opcode::power: {
        const Interval by_a = multiply(b, apply(Opcode::power, a, add(b, Interval::of(-1), false)), false);
        const Lanes first = scaled(by_a, da);
        if (b.lower == b.upper) return first;
        return a.lower > 0 ? sum(first, scaled(multiply(value, apply(Opcode::logarithm, a, a), false), db)) : unknown();
      }
      case Opcode::arctangent2: {
        if (!(b.lower > 0 || a.lower > 0 || a.upper < 0)) return unknown();  // the cut, or the origin
        const Interval length = inverse(add(square(a), square(b), false));
        return sum(scaled(multiply(b, length, false), da), scaled(negate(multiply(a, length, false)), db));
      }
      case Opcode::modulo: {
        const Interval quotient = apply(Opcode::divide, a, b);
        const float whole = std::floor(quotient.lower);
        if (quotient.maybe_nan || whole != std::floor(quotient.upper)) return unknown();
        return sum(da, scaled(Interval::of(-whole), db));
      }
      case Opcode::compare: return value.lower == value.upper ? all(0) : unknown();
      default: return unknown();
    }
  }

  /// The square root of a sum of squares is a length: its slope is that of each part times the part's share of it, which is at
  /// most 1 also where the length is 0. Other roots are known where they are off 0.
  [[nodiscard]] Lanes root(Operand argument, const Interval& value, const Lanes& slopes) const {
    std::array<Operand, 4> parts;
    std::size_t count = 0;
    if (squares_in(argument, parts, count)) {
      Lanes total = all(0), squares = all(0);
      for (std::size_t i = 0; i < count; ++i) {
        Interval rest = Interval::of(0);
        for (std::size_t j = 0; j < count; ++j)
          if (j != i) rest = add(rest, square(range_of(parts[j])), false);
        const Lanes part = slopes_of(parts[i]);
        total = sum(total, scaled(share_of_length(range_of(parts[i]), rest), part));
        for (std::size_t lane = 0; lane < slope_lanes; ++lane) {
          const float most = std::max(std::abs(part.lower[lane]), std::abs(part.upper[lane]));
          squares.upper[lane] += most * most;
        }
      }
      for (std::size_t lane = 0; lane < slope_lanes; ++lane) {  // a length changes by no more than its end moves
        const float most = std::sqrt(squares.upper[lane]) * (1 + 1e-6F);
        total.lower[lane] = std::max(total.lower[lane], -most), total.upper[lane] = std::min(total.upper[lane], most);
      }
      return total;
    }
    const auto zero = [](float slope) { return slope == 0; };
    if (slopes.known && std::all_of(slopes.lower, slopes.lower + slope_lanes, zero) &&
        std::all_of(slopes.upper, slopes.upper + slope_lanes, zero))
      return all(0);
    if (value.lower <= 0) return unknown();
    return scaled(inverse({2 * value.lower, 2 * value.upper, false}), slopes);
  }

  /// Whether a value is a square or a sum of two to four squares; `parts` gets what is squared.
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

void evaluate_slopes(const Tape& tape, const Ranges& ranges, std::span<const Vec3> directions, std::span<Interval> out) {
  const Lanes found = SlopeRun(tape, ranges, directions).run();
  for (std::size_t i = 0; i < directions.size(); ++i)
    out[i] = found.known ? Interval{found.lower[i], found.upper[i], false} : Interval::unknown();
}

}  // namespace fieldfab::frep
