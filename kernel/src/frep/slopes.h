/// Rate of change of a tape's value over a box: interval arithmetic on difference quotients.
#pragma once

#include <span>

#include "fieldfab/core/geometry.h"
#include "ranges.h"

namespace fieldfab::frep {

/// Number of directions evaluated together.
inline constexpr std::size_t slope_lanes = 8;

/// Computes Field::slopes() of a tape, along at most slope_lanes directions, from the ranges of its
/// values over the box (evaluate_ranges()).
void evaluate_slopes(const Tape& tape, const Ranges& ranges, std::span<const Vec3> directions, std::span<Interval> out);

}  // namespace fieldfab::frep
