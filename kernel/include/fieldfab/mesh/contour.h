/// Watertight contouring of any Field.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// How a Field is contoured.
struct ContourSettings {
  double voxel = 0;       ///< edge of the smallest cell, mm
  double max_error = -1;  ///< cells merge while the surface stays within this many mm; negative: a tenth of a voxel
  bool features = true;   ///< place vertices on sharp edges and corners; a sampled Field has none
};

/// The surface of the part of `field` inside `bounds`, capped where the solid goes on. Closed, 2-manifold, outward oriented,
/// without degenerate triangles or self-intersections, by construction (docs/contouring.md); empty where there is no solid.
/// The same mesh for any number of threads. Throws bad_input for bounds or voxel that are not finite and positive,
/// too_large where it would not fit in memory, cancelled.
TriangleMesh contour(const Field& field, const Box& bounds, const ContourSettings& settings,
                     Progress& progress = Progress::none());

}  // namespace fieldfab
