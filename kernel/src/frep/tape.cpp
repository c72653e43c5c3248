#include "tape.h"

#include <algorithm>
#include <unordered_map>

#include "fieldfab/frep/reference.h"
#include "interval_arithmetic.h"

namespace fieldfab::frep {
namespace {

int arity(Opcode op) { return op >= Opcode::add ? 2 : op >= Opcode::sine ? 1 : 0; }

bool is_value(Operand operand) { return (operand & constant_bit) == 0; }

/// Gives each clause a slot: the slot of an argument that is used for the last time, where there is one.
void assign_slots(Tape& tape) {
  const std::size_t count = tape.code.size();
  constexpr std::uint32_t never = ~0U;
  static thread_local std::vector<std::uint32_t> last_use, free;
  last_use.assign(count, never);
  free.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    const Clause& clause = tape.code[i];
    if (is_value(clause.a) && clause.a >= first_value) last_use[clause.a - first_value] = i;
    if (arity(clause.op) == 2 && is_value(clause.b) && clause.b >= first_value) last_use[clause.b - first_value] = i;
  }
  if (is_value(tape.root) && tape.root >= first_value) last_use[tape.root - first_value] = never;  // kept to the end
  tape.slot.resize(count);
  tape.slots = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Clause& clause = tape.code[i];
    const auto release = [&](Operand operand) {
      if (is_value(operand) && operand >= first_value && last_use[operand - first_value] == i)
        free.push_back(tape.slot[operand - first_value]);
    };
    release(clause.a);
    if (arity(clause.op) == 2 && clause.b != clause.a) release(clause.b);
    if (free.empty()) free.push_back(tape.slots++);
    tape.slot[i] = free.back();
    free.pop_back();
  }
}

/// What is known of a min or max: which argument gives its value everywhere in the box.
enum class Choice : std::uint8_t { both, first, second };

Choice choose(Opcode op, const Interval& a, const Interval& b) {
  if (a.maybe_nan || b.maybe_nan) return Choice::both;
  // On a tie the first argument gives value and gradient; so it may win by touching, the second only strictly.
  if (op == Opcode::minimum) return a.upper <= b.lower ? Choice::first : b.upper < a.lower ? Choice::second : Choice::both;
  return a.lower >= b.upper ? Choice::first : b.lower > a.upper ? Choice::second : Choice::both;
}

Interval operand_range(const Tape& tape, const Ranges& ranges, Operand operand) {
  return is_value(operand) ? ranges[operand] : Interval::of(tape.constants[operand & ~constant_bit]);
}

}  // namespace

Tape make_tape(const Expression& expression) {
  const Flat flat = flatten(expression);
  Tape tape;
  std::vector<Operand> operand(flat.order.size());
  std::unordered_map<float, std::uint32_t> constants;
  for (std::size_t i = 0; i < flat.order.size(); ++i) {
    const Flat::Entry& entry = flat.order[i];
    switch (entry.op) {
      case Opcode::constant: {
        const auto value = static_cast<float>(entry.constant);
        const auto [place, is_new] = constants.try_emplace(value, static_cast<std::uint32_t>(tape.constants.size()));
        if (is_new) tape.constants.push_back(value);
        operand[i] = place->second | constant_bit;
        break;
      }
      case Opcode::x: operand[i] = 0; break;
      case Opcode::y: operand[i] = 1; break;
      case Opcode::z: operand[i] = 2; break;
      default:
        operand[i] = first_value + static_cast<Operand>(tape.code.size());
        tape.code.push_back({entry.op, operand[entry.a], info(entry.op).arity == 2 ? operand[entry.b] : operand[entry.a]});
    }
  }
  tape.root = operand.back();
  assign_slots(tape);
  return tape;
}

Interval evaluate_ranges(const Tape& tape, const Interval& x, const Interval& y, const Interval& z, Ranges& ranges) {
  ranges.resize(first_value + tape.code.size());
  ranges.set(0, x);
  ranges.set(1, y);
  ranges.set(2, z);
  std::size_t at = first_value;
  for (const Clause& clause : tape.code) {
    const Interval a = operand_range(tape, ranges, clause.a), b = operand_range(tape, ranges, clause.b);
    const bool nan = a.maybe_nan || b.maybe_nan;
    switch (clause.op) {
      case Opcode::add: ranges.set(at, add(a, b, nan)); break;
      case Opcode::subtract: ranges.set(at, add(a, negate(b), nan)); break;
      // A value times itself is its square, and their products are the same floats.
      case Opcode::multiply: ranges.set(at, clause.a == clause.b ? square(a) : multiply(a, b, nan)); break;
      case Opcode::minimum: ranges.set(at, minimum(a, b, nan)); break;
      case Opcode::maximum: ranges.set(at, maximum(a, b, nan)); break;
      case Opcode::negate: ranges.set(at, negate(a)); break;
      case Opcode::absolute: ranges.set(at, absolute(a)); break;
      case Opcode::square: ranges.set(at, square(a)); break;
      default: ranges.set(at, apply(clause.op, a, b));
    }
    ++at;
  }
  return operand_range(tape, ranges, tape.root);
}

bool is_affine(const Tape& tape) {
  return std::all_of(tape.code.begin(), tape.code.end(), [](const Clause& clause) {
    switch (clause.op) {
      case Opcode::add:
      case Opcode::subtract:
      case Opcode::negate: return true;
      case Opcode::multiply: return !is_value(clause.a) || !is_value(clause.b);
      case Opcode::divide: return !is_value(clause.b);
      default: return false;
    }
  });
}

bool prune(const Tape& tape, const Ranges& ranges, Purpose purpose, Tape& pruned) {
  const std::size_t count = tape.code.size();
  enum Need : std::uint8_t { unneeded = 0, needed_sign = 1, needed_value = 2 };
  static thread_local std::vector<std::uint8_t> need;
  static thread_local std::vector<Choice> choice;
  static thread_local std::vector<Operand> renamed;
  need.assign(count, unneeded);
  choice.assign(count, Choice::both);
  const auto require = [&](Operand operand, std::uint8_t how) {
    if (!is_value(operand) || operand < first_value) return;
    std::uint8_t& now = need[operand - first_value];
    now = std::max(now, how);
  };

  // From the root down: what is needed, and for what. Where only a sign is needed it passes through min, max and negation.
  bool changed = false;
  require(tape.root, purpose == Purpose::occupancy ? needed_sign : needed_value);
  for (std::size_t i = count; i-- > 0;) {
    if (need[i] == unneeded) {
      changed = true;
      continue;
    }
    const Clause& clause = tape.code[i];
    if (need[i] == needed_sign && ranges[first_value + i].decided()) {
      changed = true;  // becomes a constant of that sign
      continue;
    }
    if (clause.op == Opcode::minimum || clause.op == Opcode::maximum) {
      choice[i] = choose(clause.op, operand_range(tape, ranges, clause.a), operand_range(tape, ranges, clause.b));
      changed = changed || choice[i] != Choice::both;
      if (choice[i] != Choice::second) require(clause.a, need[i]);
      if (choice[i] != Choice::first) require(clause.b, need[i]);
      continue;
    }
    if (clause.op == Opcode::absolute) {
      const Interval a = operand_range(tape, ranges, clause.a);
      if (a.lower > 0 && !a.maybe_nan) choice[i] = Choice::first, changed = true;
    }
    const std::uint8_t how =
        clause.op == Opcode::negate || choice[i] == Choice::first ? need[i] : static_cast<std::uint8_t>(needed_value);
    require(clause.a, how);
    if (arity(clause.op) == 2) require(clause.b, how);
  }
  if (!changed) return false;

  pruned.code.clear();
  pruned.constants = tape.constants;
  renamed.resize(count);
  const auto rename = [&](Operand operand) {
    return is_value(operand) && operand >= first_value ? renamed[operand - first_value] : operand;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (need[i] == unneeded) continue;
    const Clause& clause = tape.code[i];
    if (need[i] == needed_sign && ranges[first_value + i].decided()) {
      pruned.constants.push_back(ranges[first_value + i].inside() ? -1.0F : 1.0F);
      renamed[i] = static_cast<Operand>(pruned.constants.size() - 1) | constant_bit;
    } else if (choice[i] != Choice::both) {
      renamed[i] = rename(choice[i] == Choice::first ? clause.a : clause.b);
    } else {
      renamed[i] = first_value + static_cast<Operand>(pruned.code.size());
      pruned.code.push_back({clause.op, rename(clause.a), rename(clause.b)});
    }
  }
  pruned.root = rename(tape.root);
  // Constants that nothing uses any more would be copied from restriction to restriction.
  if (pruned.constants.size() > 2 * pruned.code.size() + 2) {
    std::vector<float> kept;
    static thread_local std::vector<Operand> place;
    place.assign(pruned.constants.size(), 0);
    const auto keep = [&](Operand& operand) {
      if (is_value(operand)) return;
      Operand& at = place[operand & ~constant_bit];
      if (at == 0) {
        kept.push_back(pruned.constants[operand & ~constant_bit]);
        at = static_cast<Operand>(kept.size() - 1) | constant_bit;
      }
      operand = at;
    };
    for (Clause& clause : pruned.code) keep(clause.a), keep(clause.b);
    keep(pruned.root);
    pruned.constants = std::move(kept);
  }
  assign_slots(pruned);
  return true;
}

}  // namespace fieldfab::frep
