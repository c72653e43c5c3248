/// Exact tests of two triangles of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace fieldfab {

/// Whether the vertices of a triangle lie on one line. Exact.
bool is_degenerate(std::span<const std::array<float, 3>> vertices, const std::array<std::uint32_t, 3>& triangle);

/// Whether two triangles, neither of which is degenerate, have more in common than their common vertices and the edge
/// between them. Exact.
bool triangles_overlap(std::span<const std::array<float, 3>> vertices, const std::array<std::uint32_t, 3>& one,
                       const std::array<std::uint32_t, 3>& other);

}  // namespace fieldfab
