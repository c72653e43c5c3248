/// Watertight contouring of any Field.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/field/certainty.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// How a Field is contoured.
struct ContourSettings {
  double voxel = 0;       ///< edge of the cells, mm, where the Field proves that these show all of the surface
  double max_error = -1;  ///< cells merge while the surface stays within this many mm; negative: a tenth of a voxel
  bool features = true;   ///< place vertices on sharp edges and corners; a sampled Field has none
  int depth = 6;  ///< how often a cell may be halved where that is not proved: 6 is a 64th of a voxel; 0: never, and nothing is
                  ///< looked for
  /// How many cells may be halved in all; beyond that the smaller ones stay as they are, and count as uncertain.
  std::size_t most_divided = 1'000'000;
};

/// A mesh, and how certain it is that it shows all of the solid.
struct ContourMesh : TriangleMesh {
  Certainty certainty;
};

/// The surface of the part of `field` inside `bounds`, capped where the solid goes on. Closed, 2-manifold, outward oriented,
/// without degenerate triangles or self-intersections, by construction (docs/contouring.md); empty where there is no solid.
/// Complete, or its `certainty` tells where not. The same mesh for any number of threads. Throws bad_input for bounds or voxel
/// that are not finite and positive, too_large where it would not fit in memory, cancelled.
ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& settings,
                    Progress& progress = Progress::none());

}  // namespace fieldfab
