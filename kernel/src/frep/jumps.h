/// Jumps: planes across an axis at which a modulo or a floor in a tape jumps, such as those between the copies of a
/// repeated solid.
#pragma once

#include <array>
#include <span>

#include "fieldfab/core/geometry.h"
#include "tape.h"

namespace fieldfab::frep {

/// Whether a tape has an operation that jumps.
bool has_jumps(const Tape& tape);

inline constexpr std::size_t most_pieces = 8;

/// Divides a box into pieces without jumps that follow from one coordinate alone. The pieces contain all points of the
/// box whose coordinates are floats. Returns their number: 1 if there is no such jump, or if there are too many.
std::size_t divide_at_jumps(const Tape& tape, const Box& box, std::array<Box, most_pieces>& pieces);

}  // namespace fieldfab::frep
