/// Triangulation inside each leaf cell.
#pragma once

#include "curves.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

/// A closed mesh, and the indices of its triangles in cells of at least a voxel that a sharp edge
/// may pass through.
struct FilledCells {
  TriangleMesh mesh;
  std::vector<std::uint32_t> creased;
};

/// Fills the closed loops of curves around each leaf with triangles. The triangles meet the faces
/// of the leaf in those curves only.
FilledCells fill_cells(const Field& solid, const Lattice& lattice, const Octree& octree, const Curves& curves,
                       const ContourSettings& settings, Progress& progress);

}  // namespace fieldfab::contouring
