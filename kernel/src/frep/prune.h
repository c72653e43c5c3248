/// Pruning: reduction of a tape to the part that matters in a box.
#pragma once

#include "batch.h"
#include "tape.h"

namespace fieldfab::frep {

/// Finds the values that are needed, given `choices`: `needed` gets an entry for each operand, with
/// one bit per lane. Linear, for all lanes at once.
void mark_needed(const Tape& tape, const Choice* choices, std::vector<std::uint16_t>& needed);

/// Writes the code that matters in the box of one lane (Algs 3.3 and 3.4). Returns false, and
/// leaves `pruned` unchanged, if no clause can be removed.
bool prune(const Tape& tape, const Choice* choices, const std::vector<std::uint16_t>& needed, unsigned lane,
           Tape& pruned);

}  // namespace fieldfab::frep
