/// Pruning: reduction of a tape to the part that matters in a box.
#pragma once

#include "batch.h"
#include "tape.h"

namespace fieldfab::frep {

/// Finds the values that are needed, given `choices`: `needed` gets an entry for each operand, with
/// one bit per lane. Returns the lanes in which the tape gets simpler. Linear, for all lanes at once.
std::uint16_t mark_needed(const Tape& tape, const Choice* choices, std::vector<std::uint16_t>& needed);

/// Writes the code that matters in the box of one lane (Algs 3.3 and 3.4).
void prune(const Tape& tape, const Choice* choices, const std::vector<std::uint16_t>& needed, unsigned lane,
           Tape& pruned);

}  // namespace fieldfab::frep
