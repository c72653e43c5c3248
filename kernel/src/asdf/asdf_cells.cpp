#include "asdf_cells.h"

#include <bit>
#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab {

LatticeSamples LatticeSamples::from(const LatticeRange& whole, const LatticeRange& part) const {
  LatticeSamples samples = *this;
  for (std::size_t axis = 0; axis < 3; ++axis)
    samples.value += stride[axis] * static_cast<std::size_t>(part.first[axis] - whole.first[axis]);
  samples.shift += static_cast<unsigned>(part.first[0] - whole.first[0]);
  samples.inside += (part.first[1] - whole.first[1]) +
                    static_cast<std::ptrdiff_t>(stride[2] / stride[1]) * (part.first[2] - whole.first[2]);
  return samples;
}

float LatticeSamples::corner(std::size_t number, const std::array<int, 3>& count) const {
  std::size_t at = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((number >> axis & 1U) != 0) at += stride[axis] * static_cast<std::size_t>(count[axis]);
  return value[at];
}

LatticeSamples BlockSamples::all(const std::array<std::size_t, 3>& points) {
  for (std::size_t row = 0; row < points[1] * points[2]; ++row) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < points[0]; ++i) bits |= static_cast<unsigned>(value[points[0] * row + i] < 0) << i;
    inside[row] = static_cast<std::uint16_t>(bits);
  }
  return {value.data(), inside.data(), 0, {1, points[0], points[0] * points[1]}};
}

CellMaker::CellMaker(const Box& region, const std::array<int, 3>& lattice, double max_error, bool merge_leafs,
                     std::uintmax_t memory)
    : region_(region), max_error_(max_error), merge_leafs_(merge_leafs), memory_(memory) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    count_[axis] = std::max(lattice[axis], 1);
    size_[axis] = region.size()[static_cast<Eigen::Index>(axis)] / count_[axis];
  }
}

double CellMaker::plane(int axis, int index) const {
  const auto a = static_cast<std::size_t>(axis);
  return static_cast<float>(region_.lower[axis] + (index == count_[a] ? region_.size()[axis] : size_[a] * index));
}

Box CellMaker::box(const LatticeRange& range) const {
  Box result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    result.lower[axis] = plane(axis, range.first[a]);
    result.upper[axis] = plane(axis, range.first[a] + range.count[a]);
  }
  return result;
}

BuildCell CellMaker::joined(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range) {
  if (!merge_leafs_) {  // equal cells are merged, leafs are not
    bool alike = children[0].kind == CellKind::empty || children[0].kind == CellKind::filled;
    for (const BuildCell& child : children) alike = alike && child.kind == children[0].kind;
    if (alike) return std::move(children[0]);
    BuildCell branch;
    branch.kind = CellKind::branch;
    branch.axes = axes;
    branch.children = std::move(children);
    return branch;
  }
  BuildCell result = simplified(std::move(children), axes, range, size_, max_error_);
  if (result.kind == CellKind::branch && (cells_ += result.children.size()) * sizeof(BuildCell) > memory_)
    throw Error(ErrorKind::too_large, "voxel", "the distance field would need more memory than there is");
  return result;
}

BuildCell CellMaker::block(const LatticeSamples& samples, const LatticeRange& range) {
  unsigned inside = 0, outside = 0;
  for (int k = 0; k <= range.count[2]; ++k)
    for (int j = 0; j <= range.count[1]; ++j) {
      const unsigned row = samples.inside[static_cast<std::size_t>(j) +
                                          samples.stride[2] / samples.stride[1] * static_cast<std::size_t>(k)];
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
    for (std::size_t corner = 0; corner < 8; ++corner)
      cell.corners[corner] = samples.corner(corner, {1, 1, range.count[2]});
    return cell;
  }
  if (merges() && one_leaf(samples, range.count, size_of(range), cell)) return cell;
  std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
  for (std::size_t i = 0; i < children.size(); ++i) {
    const LatticeRange child = range.child(axes, static_cast<unsigned>(i));
    children[i] = block(samples.from(range, child), child);
  }
  return joined(std::move(children), axes, range);
}

bool CellMaker::one_leaf(const LatticeSamples& samples, const std::array<int, 3>& count,
                         const std::array<double, 3>& size, BuildCell& leaf) const {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    leaf.corners[corner] = samples.corner(corner, count);
    if (!std::isfinite(leaf.corners[corner])) return false;
  }
  const auto& c = leaf.corners;
  const double allowed = max_error_ * steepness(c, size);
  double worst = 0;
  for (int k = 0; k <= count[2]; ++k)
    for (int j = 0; j <= count[1]; ++j) {
      // Along x the interpolation is linear between two values interpolated on the faces of the
      // range.
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
  leaf.slack = allowed > 0 ? std::nextafter(static_cast<float>(max_error_ * worst / allowed), INFINITY) : 0;
  return true;
}

}  // namespace fieldfab
