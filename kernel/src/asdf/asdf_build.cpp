// Construction of an Asdf: top-down by intervals, and bottom-up in blocks that are sampled densely
// (Keeter 2.4, 3.7).
#include <fmt/format.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <memory>

#include "asdf_cells.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr int task_side = 32;  // cells per axis below which a cell is one thread's work

class Builder {
 public:
  Builder(const Box& region, const std::array<int, 3>& lattice, const AsdfSettings& settings, Progress& progress)
      : maker_(region, lattice, settings.max_error, settings.merge_leafs, available_memory() / 10 * 9),
        progress_(progress) {}

  BuildCell run(const Field& field) { return cell(field.restricted(maker_.box(maker_.whole())), maker_.whole()); }

 private:
  /// Builds the cell of a range, to which the Field is already restricted.
  BuildCell cell(const Restriction& here, const LatticeRange& range) {
    progress_.check();
    if (here.range.decided()) {
      BuildCell whole;
      whole.kind = here.range.inside() ? CellKind::filled : CellKind::empty;
      report(range);
      return whole;
    }
    if (BuildCell plane; maker_.merges() && here.field->affine() && one_plane(*here.field, range, plane)) {
      report(range);
      return plane;
    }
    if (range.longest() <= block_side) {
      BuildCell block = sampled(*here.field, range);
      report(range);
      return block;
    }
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    std::array<Box, 8> boxes;
    std::array<Restriction, 8> parts;
    for (unsigned i = 0; i < children.size(); ++i) boxes[i] = maker_.box(range.child(axes, i));
    here.field->restrict_all({boxes.data(), children.size()}, Purpose::value, parts);
    const auto build_child = [&](std::size_t i) {
      children[i] = cell(parts[i], range.child(axes, static_cast<unsigned>(i)));
    };
    if (range.longest() > task_side)
      parallel_for(children.size(), build_child);
    else
      for (std::size_t i = 0; i < children.size(); ++i) build_child(i);
    return maker_.joined(std::move(children), axes, range);
  }

  /// Where the Field is affine, the corners of a range suffice. The corners of its parts are tested
  /// too, because rounding may dominate the function where numbers are large.
  bool one_plane(const Field& field, const LatticeRange& range, BuildCell& cell) const {
    const Box whole = maker_.box(range);
    std::array<std::array<float, 3>, 3> at;  // by axis: first, middle, last
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      at[axis] = {static_cast<float>(whole.lower[a]), static_cast<float>(whole.centre()[a]),
                  static_cast<float>(whole.upper[a])};
    }
    std::array<float, 27> x, y, z, value;
    for (std::size_t i = 0; i < 27; ++i) {
      x[i] = at[0][i % 3];
      y[i] = at[1][i / 3 % 3];
      z[i] = at[2][i / 9];
    }
    field.values({x.data(), y.data(), z.data(), 27}, value.data());
    unsigned inside = 0;
    for (std::size_t i = 0; i < 27; ++i) inside |= static_cast<unsigned>(value[i] < 0) << i;
    if (inside == 0 || inside == (1U << 27) - 1) {
      cell.kind = inside != 0 ? CellKind::filled : CellKind::empty;
      return true;
    }
    return maker_.one_leaf({value.data(), nullptr, 0, {1, 3, 9}}, {2, 2, 2}, maker_.size_of(range), cell);
  }

  /// Builds a block whose lattice points are evaluated in one batch.
  BuildCell sampled(const Field& field, const LatticeRange& range) {
    std::array<std::size_t, 3> points;
    for (std::size_t axis = 0; axis < 3; ++axis) points[axis] = static_cast<std::size_t>(range.count[axis]) + 1;
    std::array<float, BlockSamples::most> x, y, z;
    BlockSamples samples;
    std::size_t at = 0;
    std::array<std::array<float, block_side + 1>, 3> planes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points[axis]; ++i)
        planes[axis][i] =
            static_cast<float>(maker_.plane(static_cast<int>(axis), range.first[axis] + static_cast<int>(i)));
    for (std::size_t k = 0; k < points[2]; ++k)
      for (std::size_t j = 0; j < points[1]; ++j)
        for (std::size_t i = 0; i < points[0]; ++i, ++at)
          x[at] = planes[0][i], y[at] = planes[1][j], z[at] = planes[2][k];
    field.values({x.data(), y.data(), z.data(), at}, samples.value.data());
    return maker_.block(samples.all(points), range);
  }

  void report(const LatticeRange& range) {
    double before = done_.load(std::memory_order_relaxed);
    while (!done_.compare_exchange_weak(before, before + maker_.share(range))) {
    }
    progress_.report(before + maker_.share(range), "building the distance field");
  }

  CellMaker maker_;
  Progress& progress_;
  std::atomic<double> done_{0};
};

/// Returns the number of cells along each axis; 0 in z for a flat region.
std::array<int, 3> lattice_of(const Box& region, double voxel) {
  const Vec3 size = region.size();
  if (!region.valid() || size.x() <= 0 || size.y() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x and y");
  if (!std::isfinite(voxel) || voxel <= 0)
    throw Error(ErrorKind::bad_input, "voxel", "must be a positive number of mm");
  std::array<int, 3> lattice{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(size[static_cast<Eigen::Index>(axis)] / voxel * (1 - 1e-9));
    if (cells > (1 << 24))
      throw Error(ErrorKind::too_large, "voxel",
                  fmt::format("{:.3g} mm divides the region into {:.3g} cells a side; at most 2^24 are possible", voxel,
                              cells));
    lattice[axis] = static_cast<int>(cells);
  }
  return lattice;
}

}  // namespace

std::shared_ptr<const Asdf> Asdf::build(const Field& field, const Box& region, const AsdfSettings& wanted,
                                        Progress& progress) {
  const std::array<int, 3> lattice = lattice_of(region, wanted.voxel);
  AsdfSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = wanted.voxel / 10;
  const BuildCell root = Builder(region, lattice, settings, progress).run(field);
  return std::shared_ptr<const Asdf>(
      new Asdf(region, lattice, settings.max_error, std::make_shared<Tree>(packed(root))));
}

}  // namespace fieldfab
