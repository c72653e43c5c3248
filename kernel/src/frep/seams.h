/// Seams: places where faces of a solid's parts coincide, so that a gap or a skin without thickness is left between
/// them.
#pragma once

#include "tape.h"

namespace fieldfab::frep {

/// Tapes with more clauses are not searched for seams.
inline constexpr std::size_t most_clauses_with_seams = 64;

/// Writes a tape with the same sign everywhere but in gaps and skins between planes that coincide up to rounding: the
/// union of z < 5 and z > 5 is everything, and z < 5 without z < 5 is nothing. What a plane implies about another one
/// is left out, too. Returns false, and leaves `merged` unchanged, if nothing can be left out.
bool merge_seams(const Tape& tape, Tape& merged);

}  // namespace fieldfab::frep
