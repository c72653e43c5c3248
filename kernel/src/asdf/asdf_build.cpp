// Building an Asdf: from the top down by intervals, from the bottom up within blocks that are sampled densely (Keeter 2.4, 3.7).
#include <fmt/format.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <memory>

#include "asdf_tree.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

constexpr int block_side = 8;  // cells an axis that are sampled together
constexpr int task_side = 32;  // cells an axis below which a cell is one thread's work
constexpr std::size_t cell_bytes = sizeof(BuildCell);

class Builder {
 public:
  Builder(const Box& region, const std::array<int, 3>& lattice, const AsdfSettings& settings, Progress& progress)
      : region_(region), settings_(settings), progress_(progress) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      count_[axis] = std::max(lattice[axis], 1);
      size_[axis] = region.size()[a] / count_[axis];
    }
    memory_ = available_memory() / 10 * 9;
  }

  BuildCell run(const Field& field) {
    const LatticeRange all{{0, 0, 0}, count_};
    return cell(field.restricted(box(all)), all);
  }

 private:
  [[nodiscard]] double plane(int axis, int index) const {
    const auto a = static_cast<std::size_t>(axis);
    return static_cast<float>(region_.lower[axis] + (index == count_[a] ? region_.size()[axis] : size_[a] * index));
  }
  [[nodiscard]] Box box(const LatticeRange& range) const {
    Box result;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      result.lower[axis] = plane(axis, range.first[a]);
      result.upper[axis] = plane(axis, range.first[a] + range.count[a]);
    }
    return result;
  }
  static int longest(const LatticeRange& range) { return std::max({range.count[0], range.count[1], range.count[2]}); }

  /// The cell of a range, to which the Field is restricted already.
  BuildCell cell(const Restriction& here, const LatticeRange& range) {
    progress_.check();
    if (here.range.decided()) {
      BuildCell whole;
      whole.kind = here.range.inside() ? CellKind::filled : CellKind::empty;
      report(range);
      return whole;
    }
    if (BuildCell plane;
        settings_.merge_leafs && settings_.max_error > 0 && here.field->affine() && one_plane(*here.field, range, plane)) {
      report(range);
      return plane;
    }
    if (longest(range) <= block_side) {
      BuildCell block = sampled(*here.field, range);
      report(range);
      return block;
    }
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    std::array<Box, 8> boxes;
    std::array<Restriction, 8> parts;
    for (unsigned i = 0; i < children.size(); ++i) boxes[i] = box(range.child(axes, i));
    here.field->restrict_all({boxes.data(), children.size()}, Purpose::value, parts);
    const auto build_child = [&](std::size_t i) { children[i] = cell(parts[i], range.child(axes, static_cast<unsigned>(i))); };
    if (longest(range) > task_side)
      parallel_for(children.size(), build_child);
    else
      for (std::size_t i = 0; i < children.size(); ++i) build_child(i);
    return joined(std::move(children), axes, range);
  }

  BuildCell joined(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range) {
    if (!settings_.merge_leafs) {  // alike cells join, leafs do not
      bool alike = children[0].kind == CellKind::empty || children[0].kind == CellKind::filled;
      for (const BuildCell& child : children) alike = alike && child.kind == children[0].kind;
      if (alike) return std::move(children[0]);
      BuildCell branch;
      branch.kind = CellKind::branch;
      branch.axes = axes;
      branch.children = std::move(children);
      return branch;
    }
    BuildCell result = simplified(std::move(children), axes, range, size_, settings_.max_error);
    if (result.kind == CellKind::branch && (cells_ += result.children.size()) * cell_bytes > memory_)
      throw Error(ErrorKind::too_large, "voxel", "the distance field would need more memory than there is");
    return result;
  }

  /// A range where the Field is affine needs no more than its corners; those of its parts are looked at too, because where
  /// numbers are large, rounding may be all that is left of the function.
  bool one_plane(const Field& field, const LatticeRange& range, BuildCell& cell) const {
    const Box whole = box(range);
    std::array<std::array<float, 3>, 3> at;  // by axis: first, middle, last
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      at[axis] = {static_cast<float>(whole.lower[a]), static_cast<float>(whole.centre()[a]), static_cast<float>(whole.upper[a])};
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
    return one_leaf({value.data(), nullptr, 0, {1, 3, 9}}, {2, 2, 2}, size_of(range), cell);
  }

  /// A block whose lattice points are evaluated in one batch.
  BuildCell sampled(const Field& field, const LatticeRange& range) {
    std::array<std::size_t, 3> points;
    for (std::size_t axis = 0; axis < 3; ++axis) points[axis] = static_cast<std::size_t>(range.count[axis]) + 1;
    constexpr std::size_t most = (block_side + 1) * (block_side + 1) * (block_side + 1);
    std::array<float, most> x, y, z, value;
    std::size_t at = 0;
    std::array<std::array<float, block_side + 1>, 3> planes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points[axis]; ++i)
        planes[axis][i] = static_cast<float>(plane(static_cast<int>(axis), range.first[axis] + static_cast<int>(i)));
    for (std::size_t k = 0; k < points[2]; ++k)
      for (std::size_t j = 0; j < points[1]; ++j)
        for (std::size_t i = 0; i < points[0]; ++i, ++at) x[at] = planes[0][i], y[at] = planes[1][j], z[at] = planes[2][k];
    field.values({x.data(), y.data(), z.data(), at}, value.data());
    std::array<std::uint16_t, (block_side + 1) * (block_side + 1)> inside;
    for (std::size_t row = 0; row < points[1] * points[2]; ++row) {
      unsigned bits = 0;
      for (std::size_t i = 0; i < points[0]; ++i) bits |= static_cast<unsigned>(value[points[0] * row + i] < 0) << i;
      inside[row] = static_cast<std::uint16_t>(bits);
    }
    return from_samples({value.data(), inside.data(), 0, {1, points[0], points[0] * points[1]}}, range);
  }

  /// The values at the lattice points of a range, and how far apart neighbours are along each axis.
  struct Samples {
    const float* value;
    const std::uint16_t* inside;  // a row along x each: bit `shift` says that its first value is below 0
    unsigned shift;
    std::array<std::size_t, 3> stride;

    [[nodiscard]] const float* row(int j, int k) const {
      return value + stride[1] * static_cast<std::size_t>(j) + stride[2] * static_cast<std::size_t>(k);
    }
    [[nodiscard]] Samples from(const LatticeRange& whole, const LatticeRange& part) const {
      Samples samples = *this;
      for (std::size_t axis = 0; axis < 3; ++axis)
        samples.value += stride[axis] * static_cast<std::size_t>(part.first[axis] - whole.first[axis]);
      samples.shift += static_cast<unsigned>(part.first[0] - whole.first[0]);
      samples.inside += (part.first[1] - whole.first[1]) +
                        static_cast<std::ptrdiff_t>(stride[2] / stride[1]) * (part.first[2] - whole.first[2]);
      return samples;
    }
    /// At a corner of a range with so many cells (bits: x, y, z).
    [[nodiscard]] float corner(std::size_t number, const std::array<int, 3>& count) const {
      std::size_t at = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((number >> axis & 1U) != 0) at += stride[axis] * static_cast<std::size_t>(count[axis]);
      return value[at];
    }
  };

  BuildCell from_samples(const Samples& samples, const LatticeRange& range) {
    unsigned inside = 0, outside = 0;
    for (int k = 0; k <= range.count[2]; ++k)
      for (int j = 0; j <= range.count[1]; ++j) {
        const unsigned row =
            samples.inside[static_cast<std::size_t>(j) + samples.stride[2] / samples.stride[1] * static_cast<std::size_t>(k)];
        inside |= row;
        outside |= ~row;
      }
    const unsigned points = (2U << range.count[0]) - 1;
    inside = inside >> samples.shift & points;
    outside = outside >> samples.shift & points;
    BuildCell cell;
    if (inside == 0 || outside == 0) {
      cell.kind = inside != 0 ? CellKind::filled : CellKind::empty;
      return cell;
    }
    const unsigned axes = range.divisible();
    if (axes == 0) {
      cell.kind = CellKind::leaf;
      for (std::size_t corner = 0; corner < 8; ++corner) cell.corners[corner] = samples.corner(corner, {1, 1, range.count[2]});
      return cell;
    }
    if (settings_.merge_leafs && settings_.max_error > 0 && one_leaf(samples, range.count, size_of(range), cell)) return cell;
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    for (std::size_t i = 0; i < children.size(); ++i) {
      const LatticeRange child = range.child(axes, static_cast<unsigned>(i));
      children[i] = from_samples(samples.from(range, child), child);
    }
    return joined(std::move(children), axes, range);
  }

  [[nodiscard]] std::array<double, 3> size_of(const LatticeRange& range) const {
    return {range.count[0] * size_[0], range.count[1] * size_[1], range.count[2] * size_[2]};
  }

  /// Tries `count` cells of `size` mm in all as one leaf: interpolation must reproduce every sample to max_error, and its sign.
  bool one_leaf(const Samples& samples, const std::array<int, 3>& count, const std::array<double, 3>& size,
                BuildCell& leaf) const {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      leaf.corners[corner] = samples.corner(corner, count);
      if (!std::isfinite(leaf.corners[corner])) return false;
    }
    const auto& c = leaf.corners;
    const double allowed = settings_.max_error * steepness(c, size);
    double worst = 0;
    for (int k = 0; k <= count[2]; ++k)
      for (int j = 0; j <= count[1]; ++j) {
        // Along x interpolation is a straight line between two values interpolated on the range's faces.
        const double v = static_cast<double>(j) / count[1], w = static_cast<double>(k) / count[2];
        const auto face = [&](std::size_t i) {
          return (1 - w) * ((1 - v) * c[i] + v * c[i + 2]) + w * ((1 - v) * c[i + 4] + v * c[i + 6]);
        };
        const double low = face(0), step = (face(1) - low) / count[0];
        const float* row = samples.row(j, k);
        double farthest = 0;
        bool differs = false;
        for (int i = 0; i <= count[0]; ++i) {
          const double truth = row[i], between = low + step * i, off = std::abs(truth - between);
          farthest = off > farthest ? off : farthest;
          differs |= (truth < 0) != (between < 0) || off != off;
        }
        worst = std::max(worst, farthest);
        if (differs || !(worst <= allowed)) return false;
      }
    leaf.kind = CellKind::leaf;
    leaf.slack = allowed > 0 ? std::nextafter(static_cast<float>(settings_.max_error * worst / allowed), INFINITY) : 0;
    return true;
  }

  void report(const LatticeRange& range) {
    const double share =
        static_cast<double>(range.count[0]) / count_[0] * range.count[1] / count_[1] * range.count[2] / count_[2];
    double before = done_.load(std::memory_order_relaxed);
    while (!done_.compare_exchange_weak(before, before + share)) {
    }
    progress_.report(before + share, "building the distance field");
  }

  Box region_;
  AsdfSettings settings_;
  Progress& progress_;
  std::array<int, 3> count_{};
  std::array<double, 3> size_{};
  std::uintmax_t memory_;
  std::atomic<std::size_t> cells_{0};
  std::atomic<double> done_{0};
};

/// Cells along each axis; 0 where the region is flat in z.
std::array<int, 3> lattice_of(const Box& region, double voxel) {
  const Vec3 size = region.size();
  if (!region.valid() || size.x() <= 0 || size.y() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x and y");
  if (!std::isfinite(voxel) || voxel <= 0) throw Error(ErrorKind::bad_input, "voxel", "must be a positive number of mm");
  std::array<int, 3> lattice{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(size[static_cast<Eigen::Index>(axis)] / voxel * (1 - 1e-9));
    if (cells > (1 << 24))
      throw Error(ErrorKind::too_large, "voxel",
                  fmt::format("{:.3g} mm divides the region into {:.3g} cells a side; at most 2^24 are possible", voxel, cells));
    lattice[axis] = static_cast<int>(cells);
  }
  return lattice;
}

}  // namespace

std::shared_ptr<const Asdf> Asdf::build(const Field& field, const Box& region, const AsdfSettings& wanted, Progress& progress) {
  const std::array<int, 3> lattice = lattice_of(region, wanted.voxel);
  AsdfSettings settings = wanted;
  if (settings.max_error < 0) settings.max_error = wanted.voxel / 10;
  const BuildCell root = Builder(region, lattice, settings, progress).run(field);
  return std::shared_ptr<const Asdf>(new Asdf(region, lattice, settings.max_error, std::make_shared<Tree>(packed(root))));
}

}  // namespace fieldfab
