/// The triangles inside each leaf cell.
#pragma once

#include "contour_curves.h"

namespace fieldfab::contouring {

/// Spans the closed loops of curves around each leaf with triangles that meet its faces in those curves only.
TriangleMesh fill_cells(const Field& solid, const Lattice& lattice, const Octree& octree, const Curves& curves,
                        const ContourSettings& settings, Progress& progress);

}  // namespace fieldfab::contouring
