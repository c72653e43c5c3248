/// How fast a tape's value changes over a box: interval arithmetic on difference quotients.
#pragma once

#include <span>

#include "fieldfab/core/geometry.h"
#include "ranges.h"

namespace fieldfab::frep {

/// Directions that are followed together.
inline constexpr std::size_t slope_lanes = 8;

/// Field::slopes() of a tape, along at most slope_lanes directions, from the ranges of its values over the box (evaluate_ranges()).
void evaluate_slopes(const Tape& tape, const Ranges& ranges, std::span<const Vec3> directions, std::span<Interval> out);

}  // namespace fieldfab::frep
