/// The part of a tape that matters in a box.
#pragma once

#include "batch.h"
#include "tape.h"

namespace fieldfab::frep {

/// Which values are needed where they choose as `choices` tell: `needed` gets a place for each operand, with a bit for each lane.
/// Linear, for all lanes at once.
void mark_needed(const Tape& tape, const Choice* choices, std::vector<std::uint16_t>& needed);

/// The code that still matters in the box of one lane (Algs 3.3 and 3.4). False, and `pruned` untouched, where that is all of it.
bool prune(const Tape& tape, const Choice* choices, const std::vector<std::uint16_t>& needed, unsigned lane, Tape& pruned);

}  // namespace fieldfab::frep
