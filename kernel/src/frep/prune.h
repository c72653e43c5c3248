/// The part of a tape that matters in a box.
#pragma once

#include "batch.h"
#include "tape.h"

namespace fieldfab::frep {

/// The code that still matters where the values choose as `choices` tell in bit `lane` (Algs 3.3 and 3.4): one place for each
/// clause. False, and `pruned` untouched, where that is all of it. Linear in what is left, but for a scan of a bit a clause.
bool prune(const Tape& tape, const Choice* choices, unsigned lane, Tape& pruned);

}  // namespace fieldfab::frep
