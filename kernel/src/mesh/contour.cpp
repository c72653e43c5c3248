// Contouring in three steps: an octree of leaf cells, the curves in which the surface crosses the faces between them, and a fan
// of triangles from a vertex inside each cell to the closed loops of curves around it. docs/contouring.md has the proof.
#include "fieldfab/mesh/contour.h"

#include <algorithm>
#include <cmath>

#include "contour_cells.h"
#include "contour_curves.h"
#include "contour_octree.h"
#include "contour_sharpen.h"
#include "fieldfab/field/operations.h"

namespace fieldfab {

ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& wanted, Progress& progress) {
  using namespace contouring;
  const Lattice lattice(bounds, wanted.voxel, std::clamp(wanted.depth, 0, 6));
  ContourSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = 0.1 * settings.voxel;
  settings.features = wanted.features && !field.sampled();
  // Made steep, the bounds matter only close to them: elsewhere the Field alone is left to be asked.
  constexpr double steep = 8;
  const FieldPtr solid = intersect(field.shared_from_this(), scaled_values(box_field(bounds), steep));

  const Octree octree(*solid, lattice, settings, progress);
  progress.report(0.8, "tracing curves");
  const Curves curves = trace_curves(*solid, lattice, octree, settings.features, progress);
  progress.report(0.9, "filling cells");
  FilledCells filled = fill_cells(*solid, lattice, octree, curves, settings, progress);
  progress.report(0.95, "sharpening edges");
  for (std::size_t halvings = 0; halvings < filled.creased.size(); ++halvings) {
    const double side = std::ldexp(lattice.voxel(), -static_cast<int>(halvings));
    sharpen(*solid, side, std::clamp(0.1 * settings.max_error, 0.005 * side, 0.05 * side), filled.creased[halvings], filled.mesh,
            progress);
  }
  return {std::move(filled.mesh), octree.certainty()};
}

}  // namespace fieldfab
