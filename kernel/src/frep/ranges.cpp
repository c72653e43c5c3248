#include "ranges.h"

#include "fieldfab/frep/reference.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

Interval operand_range(const Tape& tape, const Ranges& ranges, Operand operand) {
  return is_constant(operand) ? Interval::of(tape.constants[operand & ~constant_bit]) : ranges[operand];
}

enum class Chosen : std::uint8_t { both, first, second };

/// On a tie the first argument determines value and gradient. So it is chosen if the intervals
/// touch, the second only if they do not.
Chosen choose(const Clause& clause, const Interval& a, const Interval& b, bool sign) {
  const bool numbers = !a.maybe_nan && !b.maybe_nan;
  switch (clause.op) {
    case Opcode::minimum:
      if ((numbers && a.upper <= b.lower) || (sign && b.outside())) return Chosen::first;
      return (numbers && b.upper < a.lower) || (sign && a.outside()) ? Chosen::second : Chosen::both;
    case Opcode::maximum:
      if ((numbers && a.lower >= b.upper) || (sign && b.inside())) return Chosen::first;
      return (numbers && b.lower > a.upper) || (sign && a.inside()) ? Chosen::second : Chosen::both;
    case Opcode::absolute: return a.outside() ? Chosen::first : a.inside() ? Chosen::second : Chosen::both;
    default: return Chosen::both;
  }
}

}  // namespace

namespace {

/// apply() for the most frequent operations, inlined.
inline Interval apply_inline(const Clause& clause, const Interval& a, const Interval& b) {
  const bool nan = a.maybe_nan || b.maybe_nan;
  switch (clause.op) {
    case Opcode::absolute: return absolute(a);
    case Opcode::square: return square(a);
    case Opcode::negate: return negate(a);
    case Opcode::add: return add(a, b, nan);
    case Opcode::subtract: return add(a, negate(b), nan);
    // The product of a value with itself is its square, with the same floats.
    case Opcode::multiply: return clause.a == clause.b ? square(a) : multiply(a, b, nan);
    case Opcode::minimum: return minimum(a, b, nan);
    case Opcode::maximum: return maximum(a, b, nan);
    default: return apply(clause.op, a, b);
  }
}

}  // namespace

Interval evaluate_ranges(const Tape& tape, const Interval& x, const Interval& y, const Interval& z, Ranges& ranges) {
  ranges.resize(first_value + tape.code.size());
  ranges.set(0, x);
  ranges.set(1, y);
  ranges.set(2, z);
  // Bytes may alias anything. With these pointers the compiler knows that the arrays themselves do
  // not change.
  float *const lower = ranges.lower.data(), *const upper = ranges.upper.data();
  std::uint8_t* const maybe_nan = ranges.maybe_nan.data();
  const float* const constants = tape.constants.data();
  const auto range_of = [&](Operand operand) {
    return is_constant(operand) ? Interval::of(constants[operand & ~constant_bit])
                                : Interval{lower[operand], upper[operand], maybe_nan[operand] != 0};
  };
  const Clause* const code = tape.code.data();
  for (std::size_t i = 0, count = tape.code.size(); i < count; ++i) {
    const Clause clause = code[i];
    const Interval made = apply_inline(clause, range_of(clause.a), range_of(clause.b));
    lower[first_value + i] = made.lower, upper[first_value + i] = made.upper;
    maybe_nan[first_value + i] = static_cast<std::uint8_t>(made.maybe_nan);
  }
  return operand_range(tape, ranges, tape.root);
}

void record_choices(const Tape& tape, const Ranges& ranges, Purpose purpose, unsigned lane, Choice* choices) {
  for (std::size_t i = 0; i < tape.code.size(); ++i) {
    const Clause& clause = tape.code[i];
    const Chosen chosen = choose(clause, operand_range(tape, ranges, clause.a), operand_range(tape, ranges, clause.b),
                                 purpose == Purpose::occupancy && clause.only_sign_matters);
    const auto bit = static_cast<std::uint16_t>(1U << lane);
    const auto set = [&](std::uint16_t& lanes, bool on) {
      lanes = static_cast<std::uint16_t>(on ? lanes | bit : lanes & ~bit);
    };
    set(choices[i].first, chosen == Chosen::first);
    set(choices[i].second, chosen == Chosen::second);
  }
}

}  // namespace fieldfab::frep
