/// Division of batches into parts that fit on the stack, so that Fields over Fields allocate no
/// memory.
#pragma once

#include <algorithm>
#include <array>

#include "fieldfab/field/field.h"

namespace fieldfab {

inline constexpr std::size_t chunk_size = 256;
using Chunk = std::array<float, chunk_size>;

/// Calls visit(part, first) for consecutive parts of at most chunk_size points.
template <class Visit>
void for_chunks(const Points& points, const Visit& visit) {
  for (std::size_t first = 0; first < points.count; first += chunk_size)
    visit(points.part(first, std::min(chunk_size, points.count - first)), first);
}

/// Number of directions that Fields over Fields evaluate together (Field::slopes()).
inline constexpr std::size_t slope_lanes = 8;

/// Calls visit(some, first) for consecutive parts of at most slope_lanes directions.
template <class Visit>
void for_few(std::span<const Vec3> directions, const Visit& visit) {
  for (std::size_t first = 0; first < directions.size(); first += slope_lanes)
    visit(directions.subspan(first, std::min(slope_lanes, directions.size() - first)), first);
}

}  // namespace fieldfab
