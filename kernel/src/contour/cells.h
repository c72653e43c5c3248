/// The triangles inside each leaf cell.
#pragma once

#include "curves.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

/// A closed mesh, and which of its triangles are in cells of a voxel or more that a sharp edge may pass through.
struct FilledCells {
  TriangleMesh mesh;
  std::vector<std::uint32_t> creased;
};

/// Spans the closed loops of curves around each leaf with triangles that meet its faces in those curves only.
FilledCells fill_cells(const Field& solid, const Lattice& lattice, const Octree& octree, const Curves& curves,
                       const ContourSettings& settings, Progress& progress);

}  // namespace fieldfab::contouring
