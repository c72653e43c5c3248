/// Watertight isosurface extraction from any Field.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/certainty.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Parameters of an isosurface.
struct ContourSettings {
  double voxel = 0;  ///< edge of the cells, mm, where the Field proves that such cells represent the whole surface
  /// permitted surface deviation of merged cells, mm; in parts of a voxel in proportion. Negative: a tenth of a voxel
  double max_error = -1;
  bool features = true;  ///< whether vertices are placed on sharp edges and corners; a sampled Field has none
  /// maximum number of halvings of a cell without such a proof: 6 gives a 64th of a voxel; 0: no proof is attempted
  int depth = 6;
  /// Maximum number of halved cells. Beyond it, smaller cells stay undivided and count as uncertain.
  std::size_t most_divided = 1'000'000;
};

/// A mesh and its certainty.
struct ContourMesh : TriangleMesh {
  Certainty certainty;
};

/// Computes the isosurface at value 0 of `field` inside `bounds`, mm, capped where the solid extends beyond. NaN and 0
/// are outside. The mesh is closed, 2-manifold, oriented outward, and free of degenerate triangles and
/// self-intersections by construction (docs/contouring.md); it is empty if there is no solid. It is complete, or
/// `certainty` reports the uncertain places. The mesh does not depend on the number of threads. Throws Error(bad_input)
/// unless bounds and voxel are finite and positive, Error(too_large) if it exceeds the memory, Error(cancelled).
ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& settings,
                    Progress& progress = Progress::none());

}  // namespace fieldfab
