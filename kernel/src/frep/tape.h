/// An expression as straight-line code, for intervals, pruning and batches (Keeter 3.6 to 3.8).
#pragma once

#include <vector>

#include "clause.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Straight-line code. Each value is computed once, after its arguments, and each contributes to
/// the root.
struct Tape {
  std::vector<Clause> code;
  /// Never empty. Each tape has its own: threads that prune one tape would wait for each other at a count of owners.
  std::vector<float> constants = {0};
  Operand root = 0;
  std::uint32_t slots = 0;  ///< number of slots
};

Tape make_tape(const Expression& expression);

/// Whether the tape only adds, subtracts, negates, and multiplies with and divides by constants.
bool is_affine(const Tape& tape);

/// Axes whose coordinate the tape does not read, bit i for axis i.
unsigned unread_axes(const Tape& tape);

/// Assigns slots. A clause reuses the slot of an argument that is used for the last time, if there
/// is one. `last_use`, by operand, is the last clause that uses it. Returns the number of slots.
std::uint32_t assign_slots(Clause* code, std::uint32_t count, const std::uint32_t* last_use);
/// Assigns the slots of a tape.
void choose_slots(Tape& tape);

}  // namespace fieldfab::frep
