// Contouring in three steps: an octree of leaf cells; the curves in which the surface crosses the
// faces between them; and a fan of triangles from a vertex inside each cell to the closed loops of
// curves around it. docs/contouring.md has the proof.
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

/// Returns the cells between the samples of a scan, or even divisions of them, for cells of
/// `voxel`; no cell is coarser than the samples. Returns nullopt if the voxel exceeds the spacing
/// of the samples. If the Field is a scan only and the voxel is the shortest spacing, cells are as
/// long as the spacing along each axis, since no more detail lies between samples.
std::optional<Sampling> cells_between_samples(const Field& field, double voxel) {
  constexpr double alike = 0.01;
  std::optional<Sampling> samples = field.sampling();
  if (!samples || !(voxel > 0)) return std::nullopt;
  const double shortest = samples->spacing.minCoeff();
  if (voxel > (1 + alike) * shortest) return std::nullopt;
  if (!field.sampled() || voxel < (1 - alike) * shortest)
    samples->spacing = (samples->spacing.array() / (samples->spacing.array() / voxel * (1 - alike)).ceil()).matrix();
  return samples;
}

}  // namespace

ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& wanted, Progress& progress) {
  using namespace contouring;
  ContourSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = 0.1 * settings.voxel;
  settings.features = wanted.features && !field.sampled();
  std::optional<Sampling> samples = cells_between_samples(field, settings.voxel);
  // A scan is known at its samples only, so noise between larger cells is not examined.
  if (field.sampled() && !samples) settings.depth = 0;
  // With a steep slope the bounds matter only close to them; elsewhere only the Field is evaluated.
  constexpr double steep = 8;
  FieldPtr solid = field.shared_from_this();
  const Box known = field.known_bounds();
  constexpr double at_the_end = 0.01;  // in spacings of samples: a scan ends slightly beyond its outermost samples
  const Box region = samples ? bounds.grown(at_the_end * samples->spacing.minCoeff()) : bounds;
  if (!samples || !region.contains(known.lower) || !region.contains(known.upper))
    solid = intersect(solid, scaled_values(box_field(bounds), steep));

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
    if (!cells->wants_half_voxel()) continue;
    settings.voxel /= 2;
    if (samples) samples->spacing /= 2;
  }
  const Lattice& lattice = *halved;
  const Octree& octree = *cells;
  progress.report(0.8, "tracing curves");
  const Curves curves = trace_curves(*solid, lattice, octree, settings.features, progress);
  progress.report(0.9, "filling cells");
  FilledCells filled = fill_cells(*solid, lattice, octree, curves, settings, progress);
  progress.report(0.95, "sharpening edges");
  const double side = lattice.voxel();
  sharpen(*solid, side, std::clamp(0.1 * settings.max_error, 0.005 * side, 0.05 * side), filled.creased, filled.mesh,
          progress);
  ContourMesh mesh{std::move(filled.mesh), octree.certainty()};
  if (mesh.certainty.doubt == Doubt::too_many) estimate_needs(*solid, octree.uncertain(), mesh.certainty);
  return mesh;
}

}  // namespace fieldfab
