#include "ranges.h"

#include "fieldfab/frep/reference.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

Interval operand_range(const Tape& tape, const Ranges& ranges, Operand operand) {
  return is_constant(operand) ? Interval::of((*tape.constants)[operand & ~constant_bit]) : ranges[operand];
}

enum class Chosen : std::uint8_t { both, first, second };

/// On a tie the first argument gives value and gradient; so it may win by touching, the second only strictly.
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

Interval evaluate_ranges(const Tape& tape, const Interval& x, const Interval& y, const Interval& z, Ranges& ranges) {
  ranges.resize(first_value + tape.code.size());
  ranges.set(0, x);
  ranges.set(1, y);
  ranges.set(2, z);
  std::size_t at = first_value;
  for (const Clause& clause : tape.code) {
    const Interval a = operand_range(tape, ranges, clause.a), b = operand_range(tape, ranges, clause.b);
    // A value times itself is its square, and their products are the same floats.
    const bool squared = clause.op == Opcode::multiply && clause.a == clause.b;
    ranges.set(at++, squared ? square(a) : apply(clause.op, a, b));
  }
  return operand_range(tape, ranges, tape.root);
}

void record_choices(const Tape& tape, const Ranges& ranges, Purpose purpose, unsigned lane, Choice* choices) {
  for (std::size_t i = 0; i < tape.code.size(); ++i) {
    const Clause& clause = tape.code[i];
    const Chosen chosen = choose(clause, operand_range(tape, ranges, clause.a), operand_range(tape, ranges, clause.b),
                                 purpose == Purpose::occupancy && clause.only_sign_matters);
    const auto bit = static_cast<std::uint16_t>(1U << lane);
    const auto set = [&](std::uint16_t& lanes, bool on) { lanes = static_cast<std::uint16_t>(on ? lanes | bit : lanes & ~bit); };
    set(choices[i].first, chosen == Chosen::first);
    set(choices[i].second, chosen == Chosen::second);
  }
}

}  // namespace fieldfab::frep
