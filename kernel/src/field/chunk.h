/// Batches cut into pieces that fit on the stack, so that Fields over Fields need no memory of their own.
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

}  // namespace fieldfab
