// Directions of slopes, a few at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "fieldfab/core/geometry.h"

namespace fieldfab::openscad {

inline constexpr std::size_t lanes = 8;  // number of directions evaluated together

/// Calls visit(some, first) for consecutive parts of at most `lanes` directions.
template <class Visit>
void for_few(std::span<const Vec3> directions, const Visit& visit) {
  for (std::size_t first = 0; first < directions.size(); first += lanes)
    visit(directions.subspan(first, std::min(lanes, directions.size() - first)), first);
}

}  // namespace fieldfab::openscad
