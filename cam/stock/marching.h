/// Polygons of a cube by the signs of its corners (Hahn 4.3: marching cubes and squares with one reading of ambiguous faces).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fieldfab::cam {

/// Corners are numbered x + 2 y + 4 z. Edge 4 a + u + 2 v runs along axis a from the corner whose two other coordinates, in
/// cyclic order, are u and v.
struct CubeCase {
  std::vector<std::array<std::int8_t, 3>> triangles;  ///< of edges; 12 + i is the middle of loop i
  std::vector<std::vector<std::int8_t>> middles;      ///< loops that need a vertex in their middle
};

/// Of the 256 cases, the bits of solid corners being the index. On a face with two solid corners across, they are apart. No
/// triangle's inner edge lies in a face, so that the surface is a manifold.
const std::array<CubeCase, 256>& cube_cases();

}  // namespace fieldfab::cam
