/// Pieces of a stock's surface for display: with normals, and with fewer triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/cam/stock/lattice.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::cam {

/// Arrays for drawing. Normals are weighted by the areas of adjacent triangles and have length 1.
struct DrawnSurface {
  std::vector<std::array<float, 3>> vertices, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> cuts;  ///< number of the cut that made each vertex
};

/// Returns all of a mesh. `cuts` has one entry per vertex or is empty.
DrawnSurface drawn(const TriangleMesh& mesh, std::vector<std::uint32_t> cuts = {});

/// Returns a simplified surface. Vertices within axis-aligned flat areas made by one cut are merged in blocks of six by
/// six. If `coarse` > 1, vertices in a block of `coarse` lattice cells with similar normals are merged as well.
/// Vertices within a cell of the faces of `region` (in cells from the lattice's first point) stay unchanged, so that
/// pieces still meet.
DrawnSurface simplified(const DrawnSurface& surface, const StockLattice& lattice, const Box& region, int coarse);

}  // namespace fieldfab::cam
