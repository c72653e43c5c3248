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
namespace {

/// The samples of a scan, and what lies evenly between them, as far as cells of `voxel` ask for it: then no cell sees less than
/// the samples tell. Nothing where the cells are larger than their distances.
std::optional<Sampling> samples_for_cells(const Field& field, double voxel) {
  constexpr double alike = 0.01;  // cells this near to the samples' shortest distance are the samples' own, along each axis
  std::optional<Sampling> samples = field.sampling();
  if (!samples || !(voxel > 0) || voxel > (1 + alike) * samples->spacing.minCoeff()) return std::nullopt;
  if (voxel < (1 - alike) * samples->spacing.minCoeff())
    samples->spacing = (samples->spacing.array() / (samples->spacing.array() / voxel - 1e-6).ceil()).matrix();
  return samples;
}

}  // namespace

ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& wanted, Progress& progress) {
  using namespace contouring;
  ContourSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = 0.1 * settings.voxel;
  settings.features = wanted.features && !field.sampled();
  const std::optional<Sampling> samples = samples_for_cells(field, settings.voxel);
  // Nothing is known of a scan but its samples: noise that falls between larger cells is not to be looked into.
  if (field.sampled() && !samples) settings.depth = 0;
  // Made steep, the bounds matter only close to them: elsewhere the Field alone is left to be asked.
  constexpr double steep = 8;
  const FieldPtr solid = intersect(field.shared_from_this(), scaled_values(box_field(bounds), steep));

  std::optional<Lattice> halved;
  std::optional<Octree> cells;
  int depth = std::clamp(settings.depth, 0, 6);
  for (;; --depth) {
    if (samples)
      halved.emplace(bounds, *samples, depth);
    else
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
