// Contouring in three steps: an octree of leaf cells, the curves in which the surface crosses the faces between them, and a fan
// of triangles from a vertex inside each cell to the closed loops of curves around it. docs/contouring.md has the proof.
#include "fieldfab/contour/contour.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cells.h"
#include "curves.h"
#include "fieldfab/field/operations.h"
#include "needs.h"
#include "octree.h"
#include "sharpen.h"

namespace fieldfab {

ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& wanted, Progress& progress) {
  using namespace contouring;
  ContourSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = 0.1 * settings.voxel;
  settings.features = wanted.features && !field.sampled();
  if (field.sampled()) settings.depth = 0;  // nothing is known of a scan but its samples: noise is not to be looked into
  // Made steep, the bounds matter only close to them: elsewhere the Field alone is left to be asked.
  constexpr double steep = 8;
  const FieldPtr solid = intersect(field.shared_from_this(), scaled_values(box_field(bounds), steep));

  std::optional<Lattice> halved;
  std::optional<Octree> cells;
  int depth = std::clamp(settings.depth, 0, 6);
  for (;; --depth) {
    halved.emplace(bounds, settings.voxel, depth);
    cells.emplace(*solid, *halved, settings, progress);
    if (!cells->wants_half_voxel() && !cells->too_deep()) break;
    if (cells->wants_half_voxel()) settings.voxel /= 2;
  }
  const Lattice& lattice = *halved;
  const Octree& octree = *cells;
  progress.report(0.8, "tracing curves");
  const Curves curves = trace_curves(*solid, lattice, octree, settings.features, progress);
  progress.report(0.9, "filling cells");
  FilledCells filled = fill_cells(*solid, lattice, octree, curves, settings, progress);
  progress.report(0.95, "sharpening edges");
  const double side = lattice.voxel();
  sharpen(*solid, side, std::clamp(0.1 * settings.max_error, 0.005 * side, 0.05 * side), filled.creased, filled.mesh, progress);
  ContourMesh mesh{std::move(filled.mesh), octree.certainty()};
  if (mesh.certainty.doubt == Doubt::too_many) estimate_needs(*solid, octree.uncertain(), mesh.certainty);
  return mesh;
}

}  // namespace fieldfab
