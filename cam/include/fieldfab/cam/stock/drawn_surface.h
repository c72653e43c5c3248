/// Parts of a stock's surface as they are drawn: with normals, and with fewer triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/cam/stock/lattice.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::cam {

/// Arrays for drawing. Normals are weighed by the areas of the triangles that meet at a vertex.
struct DrawnSurface {
  std::vector<std::array<float, 3>> vertices, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> cuts;  ///< what made each vertex
};

/// All of a mesh. `cuts` may be empty.
DrawnSurface drawn(const TriangleMesh& mesh, std::vector<std::uint32_t> cuts = {});

/// The same with fewer triangles: vertices in the middle of level flats that one cut left are united, six by six; then, where
/// `coarse` is above 1, all vertices that share a block of so many lattice cells and face about the same way. What lies within a
/// cell of the faces of `region` (in cells from the lattice's first point) stays as it is, so that pieces still meet.
DrawnSurface simplified(const DrawnSurface& surface, const StockLattice& lattice, const Box& region, int coarse);

}  // namespace fieldfab::cam
