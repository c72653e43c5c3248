#include "prune.h"

#include <algorithm>

namespace fieldfab::frep {
namespace {

// Choices of a box are unpredictable for a processor, and a mispredicted branch costs more than a
// clause. So this code does not branch on choices or on kinds of operands; it writes unwanted
// results to a place that is never read.

/// All ones for a constant, otherwise zero.
Operand if_constant(Operand operand) { return static_cast<Operand>(static_cast<std::int32_t>(operand) >> 31); }

/// Index of an operand's data; constants share the entry of x, which is unused.
Operand place_of(Operand operand) { return operand & ~if_constant(operand); }

/// Memory kept per thread.
struct Workspace {
  std::vector<std::uint32_t> kept;      ///< indices of clauses of the old tape
  std::vector<Operand> renamed;         ///< by old operand: its number in the pruned tape
  std::vector<Clause> code;             ///< of the pruned tape
  std::vector<std::uint32_t> last_use;  ///< by new operand
  std::vector<float> constants;         ///< of the pruned tape
};

}  // namespace

std::uint16_t mark_needed(const Tape& tape, const Choice* choices, std::vector<std::uint16_t>& needed) {
  needed.assign(first_value + tape.code.size(), 0);
  std::uint16_t* const lanes = needed.data();
  lanes[place_of(tape.root)] = 0xffff;
  unsigned simpler = 0;
  for (std::size_t i = tape.code.size(); i-- > 0;) {
    const Clause& clause = tape.code[i];
    const std::uint16_t here = lanes[first_value + i];
    if (here == 0) {  // one branch on data: unneeded clauses follow each other
      simpler = 0xffff;
      continue;
    }
    simpler |= ~here | choices[i].first | choices[i].second;
    lanes[place_of(clause.a)] |= static_cast<std::uint16_t>(here & ~(choices[i].second & ~choices[i].first));
    lanes[place_of(clause.b)] |= static_cast<std::uint16_t>(here & ~choices[i].first);
  }
  return static_cast<std::uint16_t>(simpler);
}

void prune(const Tape& tape, const Choice* choices, const std::vector<std::uint16_t>& needed, unsigned lane,
           Tape& pruned) {
  static thread_local Workspace kept_workspace;
  Workspace& work = kept_workspace;
  const std::size_t count = tape.code.size();
  work.kept.resize(count + 1);
  std::uint32_t* const kept = work.kept.data();
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    kept[left] = i;
    left += needed[first_value + i] >> lane & 1U;
  }

  work.renamed.resize(first_value + count);
  work.code.resize(left + 1);
  work.last_use.resize(first_value + left + 1);
  Operand* const renamed = work.renamed.data();
  std::uint32_t* const last_use = work.last_use.data();
  for (Operand axis = 0; axis < first_value; ++axis) renamed[axis] = axis;
  work.constants.resize(2 * left + 2);
  float* const constants = work.constants.data();
  std::uint32_t constant_count = 0;
  const auto new_name = [&](Operand operand) {
    const Operand constant = if_constant(operand);
    constants[constant_count] = tape.constants[operand & ~constant_bit & constant];
    const Operand name = ((constant_bit | constant_count) & constant) | (renamed[place_of(operand)] & ~constant);
    constant_count += constant & 1U;
    return name;
  };
  std::uint32_t made = 0;
  for (std::uint32_t k = 0; k < left; ++k) {
    const std::uint32_t i = kept[k];
    const Clause& clause = tape.code[i];
    const Operand a = new_name(clause.a), b = new_name(clause.b);
    const unsigned first = choices[i].first >> lane & 1U, second = choices[i].second >> lane & ~first & 1U;
    const unsigned negative = second & static_cast<unsigned>(clause.op == Opcode::absolute);  // |a| for a < 0
    const unsigned emitted = negative | ((first | second) ^ 1U);
    work.code[made] = {negative != 0 ? Opcode::negate : clause.op, clause.only_sign_matters, 0, a, b};
    last_use[first_value + made] = ~0U;
    last_use[place_of(a) & (0U - emitted)] = made;
    last_use[place_of(b) & (0U - emitted)] = made;
    const Operand chosen_name = (a & (0U - first)) | (b & (0U - second));
    renamed[first_value + i] = ((first_value + made) & (0U - emitted)) | (chosen_name & (emitted - 1U));
    made += emitted;
  }
  pruned.root = new_name(tape.root);
  pruned.constants.assign(constants, constants + std::max(constant_count, 1U));
  pruned.slots = assign_slots(work.code.data(), made, last_use);
  pruned.code.assign(work.code.data(), work.code.data() + made);
}

}  // namespace fieldfab::frep
