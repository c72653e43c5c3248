// Contouring in three steps: an octree of leaf cells; the curves in which the surface crosses the
// faces between them; and a fan of triangles from a vertex inside each cell to the closed loops of
// curves around it. docs/contouring.md has the proof.
#include "fieldfab/contour/contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "cells.h"
#include "curves.h"
#include "fieldfab/contour/bricks.h"
#include "fieldfab/core/error.h"
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

/// What contour() and ContourBricks do alike before they divide the lattice.
struct Task {
  ContourSettings settings;
  std::optional<Sampling> samples;  ///< cells, if they are those between the samples of a scan
  FieldPtr solid;                   ///< the Field, cut off at the bounds
};

Task task_of(const Field& field, const Box& bounds, const ContourSettings& wanted) {
  Task task{wanted, cells_between_samples(field, wanted.voxel), field.shared_from_this()};
  if (wanted.max_error < 0) task.settings.max_error = 0.1 * wanted.voxel;
  task.settings.features = wanted.features && !field.sampled();
  // A scan is known at its samples only, so noise between larger cells is not examined.
  if (field.sampled() && !task.samples) task.settings.depth = 0;
  // With a steep slope the bounds matter only close to them; elsewhere only the Field is evaluated.
  constexpr double steep = 8;
  const Box known = field.known_bounds();
  constexpr double at_the_end = 0.01;  // in spacings of samples: a scan ends slightly beyond its outermost samples
  const Box region = task.samples ? bounds.grown(at_the_end * task.samples->spacing.minCoeff()) : bounds;
  if (!task.samples || !region.contains(known.lower) || !region.contains(known.upper))
    task.solid = intersect(task.solid, scaled_values(box_field(bounds), steep));
  return task;
}

/// Levels above a voxel of the largest leaf of a sampled Field. The leafs of a brick depend on no cells farther away
/// than such a leaf is wide, and cells of 32 x 32 voxels are few beside those where the surface is not flat.
constexpr int levels_of_sampled_leaf = 5;

/// Throws bad_input if there is no such brick.
contouring::Extent extent_of(const std::array<int, 3>& brick, int cells, const std::array<int, 3>& count) {
  contouring::Extent extent{
      .side = cells, .margin = 1 << levels_of_sampled_leaf, .greatest_leaf = levels_of_sampled_leaf};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (brick[axis] < 0 || brick[axis] >= count[axis])
      throw Error(ErrorKind::bad_input, "brick",
                  fmt::format("there is no brick {}, {}, {} of {} x {} x {}", brick[0], brick[1], brick[2], count[0],
                              count[1], count[2]));
    extent.lower[axis] = brick[axis] * cells;
  }
  return extent;
}

}  // namespace

ContourMesh contour(const Field& field, const Box& bounds, const ContourSettings& wanted, Progress& progress) {
  using namespace contouring;
  Task task = task_of(field, bounds, wanted);
  ContourSettings& settings = task.settings;
  const Field& solid = *task.solid;
  std::optional<Lattice> halved;
  std::optional<Octree> cells;
  int depth = std::clamp(settings.depth, 0, 6);
  for (;; --depth) {
    if (task.samples)
      halved.emplace(bounds, *task.samples, depth);
    else
      halved.emplace(bounds, settings.voxel, depth);
    Extent extent = Extent::whole(*halved);
    if (field.sampled())
      extent.greatest_leaf = std::min(extent.greatest_leaf, halved->voxel_level() + levels_of_sampled_leaf);
    cells.emplace(solid, *halved, extent, settings, progress);
    if (!cells->wants_half_voxel() && !cells->too_deep()) break;
    if (!cells->wants_half_voxel()) continue;
    settings.voxel /= 2;
    if (task.samples) task.samples->spacing /= 2;
  }
  const Lattice& lattice = *halved;
  const Octree& octree = *cells;
  progress.report(0.8, "tracing curves");
  const Curves curves = trace_curves(solid, lattice, octree, settings.features, progress);
  progress.report(0.9, "filling cells");
  FilledCells filled = fill_cells(solid, lattice, octree, curves, settings, progress);
  progress.report(0.95, "sharpening edges");
  const double side = lattice.voxel();
  sharpen(solid, side, std::clamp(0.1 * settings.max_error, 0.005 * side, 0.05 * side), filled.creased, filled.mesh,
          progress);
  ContourMesh mesh{std::move(filled.mesh), octree.certainty()};
  if (mesh.certainty.doubt == Doubt::too_many) estimate_needs(solid, octree.uncertain(), mesh.certainty);
  return mesh;
}

ContourBricks::ContourBricks(const Box& bounds, const ContourSettings& settings, int cells)
    : bounds_(bounds), settings_(settings), cells_(cells) {
  constexpr int least = 1 << levels_of_sampled_leaf;
  if (cells < least || !std::has_single_bit(static_cast<unsigned>(cells)))
    throw Error(ErrorKind::bad_input, "cells", fmt::format("{} is not a power of two of at least {}", cells, least));
  const contouring::Lattice lattice(bounds, settings.voxel, 0);
  for (int axis = 0; axis < 3; ++axis) {
    int& count = count_[static_cast<std::size_t>(axis)] = 1;
    while (count * cells < 1 << lattice.root_level() && lattice.plane(axis, count * cells) <= bounds.upper[axis])
      ++count;
  }
}

Box ContourBricks::surroundings(const std::array<int, 3>& brick) const {
  const contouring::Lattice lattice(bounds_, settings_.voxel, 0);
  const contouring::Extent extent = extent_of(brick, cells_, count_);
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t first = extent.lower[static_cast<std::size_t>(axis)];
    box.lower[axis] = lattice.plane(axis, first - extent.margin);
    box.upper[axis] = lattice.plane(axis, first + extent.side + extent.margin);
  }
  return box.grown(lattice.voxel());
}

BrickMesh ContourBricks::mesh(const Field& field, const std::array<int, 3>& brick, Progress& progress) const {
  using namespace contouring;
  if (!field.sampled() || field.sampling())
    throw Error(ErrorKind::bad_input, "field", "only sampled distances, such as an .asdf file, are meshed in bricks");
  const Task task = task_of(field, bounds_, settings_);
  const Lattice lattice(bounds_, settings_.voxel, 0);
  const Extent extent = extent_of(brick, cells_, count_);
  const Octree octree(*task.solid, lattice, extent, task.settings, progress);
  progress.report(0.8, "tracing curves");
  const Curves curves = trace_curves(*task.solid, lattice, octree, false, progress);
  progress.report(0.9, "filling cells");
  BrickMesh mesh{fill_cells(*task.solid, lattice, octree, curves, task.settings, progress).mesh, {}};
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double at = mesh.vertices[i][a];
      if (at != lattice.plane(axis, extent.lower[a]) && at != lattice.plane(axis, extent.lower[a] + extent.side))
        continue;
      mesh.seam.push_back(i);
      break;
    }
  return mesh;
}

}  // namespace fieldfab
