#include "tape.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace fieldfab::frep {
namespace {

/// Marks clauses that affect only the sign of the root: those reached from the root through min,
/// max and negation.
void mark_signs(Tape& tape) {
  for (Clause& clause : tape.code) clause.only_sign_matters = true;
  for (std::size_t i = tape.code.size(); i-- > 0;) {
    const Clause& clause = tape.code[i];
    const bool passes = clause.op == Opcode::minimum || clause.op == Opcode::maximum || clause.op == Opcode::negate;
    if (passes && clause.only_sign_matters) continue;
    for (const Operand operand : {clause.a, clause.b})
      if (is_made(operand)) tape.code[operand - first_value].only_sign_matters = false;
  }
}

}  // namespace

std::uint32_t assign_slots(Clause* code, std::uint32_t count, const std::uint32_t* last_use) {
  static thread_local std::vector<std::uint32_t> kept;
  kept.resize(std::size_t{2} * count + 2);
  std::uint32_t* const free = kept.data();  // a stack, without branches, which would be mispredicted
  std::uint32_t top = 0, slots = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    Clause& clause = code[i];
    const auto release = [&](Operand operand, bool other) {
      const bool made = is_made(operand);
      free[top] = code[made ? operand - first_value : i].slot;
      top += made && other && last_use[made ? operand : 0] == i;
    };
    release(clause.a, true);
    release(clause.b, clause.b != clause.a);
    const bool none = top == 0;
    clause.slot = none ? slots : free[none ? 0 : top - 1];
    slots += none;
    top -= !none;
  }
  return slots;
}

void choose_slots(Tape& tape) {
  std::vector<std::uint32_t> last_use(first_value + tape.code.size(), ~0U);
  for (std::uint32_t i = 0; i < tape.code.size(); ++i)
    for (const Operand argument : {tape.code[i].a, tape.code[i].b})
      if (!is_constant(argument)) last_use[argument] = i;
  tape.slots = assign_slots(tape.code.data(), static_cast<std::uint32_t>(tape.code.size()), last_use.data());
}

Tape make_tape(const Expression& expression) {
  const Flat flat = flatten(expression);
  Tape tape;
  std::vector<float> constants;
  std::vector<Operand> operand(flat.order.size());
  std::unordered_map<std::uint32_t, std::uint32_t> known;  // by bits: 0 and -0 differ
  for (std::size_t i = 0; i < flat.order.size(); ++i) {
    const Flat::Entry& entry = flat.order[i];
    switch (entry.op) {
      case Opcode::constant: {
        const auto value = static_cast<float>(entry.constant);
        const auto [place, is_new] =
            known.try_emplace(std::bit_cast<std::uint32_t>(value), static_cast<std::uint32_t>(constants.size()));
        if (is_new) constants.push_back(value);
        operand[i] = place->second | constant_bit;
        break;
      }
      case Opcode::x: operand[i] = 0; break;
      case Opcode::y: operand[i] = 1; break;
      case Opcode::z: operand[i] = 2; break;
      default: {
        const Operand a = operand[entry.a], b = arity(entry.op) == 2 ? operand[entry.b] : a;
        operand[i] = first_value + static_cast<Operand>(tape.code.size());
        tape.code.push_back({entry.op, true, 0, a, b});
      }
    }
  }
  tape.root = operand.back();
  if (!constants.empty()) tape.constants = std::move(constants);
  mark_signs(tape);
  choose_slots(tape);
  return tape;
}

bool is_affine(const Tape& tape) {
  return std::all_of(tape.code.begin(), tape.code.end(), [](const Clause& clause) {
    switch (clause.op) {
      case Opcode::add:
      case Opcode::subtract:
      case Opcode::negate: return true;
      case Opcode::multiply: return is_constant(clause.a) || is_constant(clause.b);
      case Opcode::divide: return is_constant(clause.b);
      default: return false;
    }
  });
}

unsigned unread_axes(const Tape& tape) {
  unsigned read = 0;
  const auto note = [&](Operand operand) { read |= operand < first_value ? 1U << operand : 0; };
  note(tape.root);
  for (const Clause& clause : tape.code) note(clause.a), note(clause.b);
  return ~read & 7U;
}

}  // namespace fieldfab::frep
