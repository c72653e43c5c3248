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

  BuildCell run(const Field& field) { return cell(field.shared_from_this(), {{0, 0, 0}, count_}); }

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

  BuildCell cell(const FieldPtr& field, const LatticeRange& range) {
    progress_.check();
    const Restriction here = field->restricted(box(range));
    if (here.range.decided()) {
      BuildCell whole;
      whole.kind = here.range.inside() ? CellKind::filled : CellKind::empty;
      report(range);
      return whole;
    }
    if (longest(range) <= block_side) {
      BuildCell block = sampled(*here.field, range);
      report(range);
      return block;
    }
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    const auto build_child = [&](std::size_t i) { children[i] = cell(here.field, range.child(axes, static_cast<unsigned>(i))); };
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
    const auto sample = [&](int i, int j, int k) {
      return value[static_cast<std::size_t>(i - range.first[0]) +
                   points[0] *
                       (static_cast<std::size_t>(j - range.first[1]) + points[1] * static_cast<std::size_t>(k - range.first[2]))];
    };
    return from_samples(sample, range);
  }

  template <class Sample>
  BuildCell from_samples(const Sample& sample, const LatticeRange& range) {
    bool inside = false, outside = false;
    for (int k = range.first[2]; k <= range.first[2] + range.count[2]; ++k)
      for (int j = range.first[1]; j <= range.first[1] + range.count[1]; ++j)
        for (int i = range.first[0]; i <= range.first[0] + range.count[0]; ++i) (sample(i, j, k) < 0 ? inside : outside) = true;
    BuildCell cell;
    if (!inside || !outside) {
      cell.kind = inside ? CellKind::filled : CellKind::empty;
      return cell;
    }
    const unsigned axes = range.divisible();
    if (axes == 0) {
      cell.kind = CellKind::leaf;
      for (int corner = 0; corner < 8; ++corner)
        cell.corners[static_cast<std::size_t>(corner)] =
            sample(range.first[0] + (corner & 1), range.first[1] + (corner >> 1 & 1), range.first[2] + (corner >> 2));
      return cell;
    }
    if (settings_.merge_leafs && settings_.max_error > 0 && one_leaf(sample, range, cell)) return cell;
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    for (std::size_t i = 0; i < children.size(); ++i)
      children[i] = from_samples(sample, range.child(axes, static_cast<unsigned>(i)));
    return joined(std::move(children), axes, range);
  }

  /// Tries the whole of `range` as one leaf: interpolation must reproduce every sample to max_error, and its sign.
  template <class Sample>
  bool one_leaf(const Sample& sample, const LatticeRange& range, BuildCell& leaf) const {
    std::array<double, 3> size;
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = range.count[axis] * size_[axis];
    for (int corner = 0; corner < 8; ++corner) {
      const float value =
          sample(range.first[0] + (corner & 1) * range.count[0], range.first[1] + (corner >> 1 & 1) * range.count[1],
                 range.first[2] + (corner >> 2) * range.count[2]);
      if (!std::isfinite(value)) return false;
      leaf.corners[static_cast<std::size_t>(corner)] = value;
    }
    const auto& c = leaf.corners;
    const double allowed = settings_.max_error * steepness(c, size);
    double worst = 0;
    for (int k = 0; k <= range.count[2]; ++k)
      for (int j = 0; j <= range.count[1]; ++j) {
        // Along x interpolation is a straight line between two values interpolated on the range's faces.
        const double v = static_cast<double>(j) / range.count[1], w = static_cast<double>(k) / range.count[2];
        const auto face = [&](std::size_t i) {
          return (1 - w) * ((1 - v) * c[i] + v * c[i + 2]) + w * ((1 - v) * c[i + 4] + v * c[i + 6]);
        };
        const double low = face(0), high = face(1);
        for (int i = 0; i <= range.count[0]; ++i) {
          const double truth = sample(range.first[0] + i, range.first[1] + j, range.first[2] + k),
                       between = low + (high - low) * i / range.count[0];
          worst = std::max(worst, std::abs(truth - between));
          if (!(worst <= allowed) || (truth < 0) != (between < 0)) return false;
        }
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
