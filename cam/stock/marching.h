/// Polygons of a cube by the signs of its corners (Hahn 4.3: marching cubes and squares with a
/// consistent resolution of ambiguous faces).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fieldfab::cam {

/// Corners are numbered x + 2 y + 4 z. Edge 4 a + u + 2 v is parallel to axis a and starts at the
/// corner whose other coordinates, in cyclic order, are u and v.
struct CubeCase {
  std::vector<std::array<std::int8_t, 3>> triangles;  ///< indices of edges; 12 + i is the middle of
                                                      ///< loop i
  std::vector<std::vector<std::int8_t>> middles;      ///< loops that require a vertex in their middle
};

/// Table of the 256 cases, indexed by the bits of solid corners. Solid corners on a diagonal of a
/// face are not connected. No inner edge of a triangulation lies in a face, so that the surface is
/// a manifold.
const std::array<CubeCase, 256>& cube_cases();

}  // namespace fieldfab::cam
