#include "asdf_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab {

LeafSamples LeafSamples::of(const std::array<float, 8>& distances) {
  float greatest = 0;
  for (const float d : distances)
    if (std::isfinite(d)) greatest = std::max(greatest, std::abs(d));
  constexpr float steps = 32767;
  LeafSamples samples{std::max(greatest / steps, 1e-35F), {}};
  for (std::size_t i = 0; i < 8; ++i) {
    const float d = distances[i];
    if (!std::isfinite(d)) {
      samples.distance[i] = d < 0 ? -32767 : 32767;  // NaN counts as outside
      continue;
    }
    const auto step = static_cast<int>(std::lround(d / samples.step));
    samples.distance[i] = static_cast<std::int16_t>(d < 0 ? std::clamp(step, -32767, -1) : std::clamp(step, 0, 32767));
  }
  return samples;
}

LatticeRange LatticeRange::child(unsigned axes, unsigned number) const {
  LatticeRange part = *this;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if ((axes >> axis & 1U) == 0) continue;
    const int lower = lower_count(static_cast<int>(axis));
    const bool upper = (number & 1U) != 0;
    number >>= 1U;
    part.first[axis] += upper ? lower : 0;
    part.count[axis] = upper ? count[axis] - lower : lower;
  }
  return part;
}

unsigned LatticeRange::divisible() const {
  unsigned axes = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
    if (count[axis] > 1) axes |= 1U << axis;
  return axes;
}

double steepness(const std::array<float, 8>& corners, const std::array<double, 3>& size) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (size[axis] <= 0) continue;
    // Along an axis the slope of a trilinear function is a weighted mean of the slopes of the four
    // edges.
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1U) != 0) continue;
      const double difference = double{corners[corner | std::size_t{1} << axis]} - corners[corner];
      least = std::min(least, difference), most = std::max(most, difference);
    }
    const double slope = std::max({least, -most, 0.0}) / size[axis];
    sum += slope * slope;
  }
  return std::sqrt(sum);
}

namespace {

/// Tries to merge two leafs along `axis`. The interpolation over both differs from that of each by
/// a function that is linear along each axis; so the difference is greatest at a corner, and only
/// the four corners in the middle can differ. Its sum with the earlier slack of both bounds the
/// distance to each sample that was merged; it must not exceed max_error.
bool join_leafs(const BuildCell& a, const BuildCell& b, std::size_t axis, double share,
                const std::array<double, 3>& size_a, const std::array<double, 3>& size_b, double max_error,
                BuildCell& joined) {
  double off = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    if ((corner >> axis & 1U) != 0) continue;
    const std::size_t upper = corner | std::size_t{1} << axis;
    const double middle = a.corners[upper], between = (1 - share) * a.corners[corner] + share * b.corners[upper];
    if (!std::isfinite(middle) || !std::isfinite(between) || (middle < 0) != (between < 0)) return false;
    off = std::max(off, std::abs(between - middle));
    joined.corners[corner] = a.corners[corner];
    joined.corners[upper] = b.corners[upper];
  }
  const double steep = std::min(steepness(a.corners, size_a), steepness(b.corners, size_b));
  const double slack = std::max(a.slack, b.slack) + (off > 0 ? off / steep : 0);
  if (!(slack <= max_error)) return false;
  joined.slack = std::nextafter(static_cast<float>(slack), INFINITY);
  joined.kind = CellKind::leaf;
  return true;
}

/// Tries to merge two cells of one kind along `axis`.
bool join(BuildCell& a, BuildCell& b, unsigned axis, const LatticeRange& range_a, const LatticeRange& range_b,
          const std::array<double, 3>& cell_size, double max_error, BuildCell& joined) {
  if (a.kind == CellKind::empty || a.kind == CellKind::filled) {
    joined.kind = a.kind;
    return true;
  }
  if (a.kind == CellKind::leaf) {
    std::array<double, 3> size_a, size_b;
    for (std::size_t i = 0; i < 3; ++i)
      size_a[i] = range_a.count[i] * cell_size[i], size_b[i] = range_b.count[i] * cell_size[i];
    const double share = static_cast<double>(range_a.count[axis]) / (range_a.count[axis] + range_b.count[axis]);
    return join_leafs(a, b, axis, share, size_a, size_b, max_error, joined);
  }
  return a.axes == b.axes && (a.axes >> axis & 1U) == 0;
}

/// Returns the number of a child of a branch that splits `axes`, given its place (bit 0: upper
/// along x, ...).
unsigned child_number(unsigned axes, unsigned place) {
  unsigned number = 0, bit = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
    if ((axes >> axis & 1U) != 0) number |= (place >> axis & 1U) << bit++;
  return number;
}

/// Returns the place of a child, given its number.
unsigned child_place(unsigned axes, unsigned number) {
  unsigned place = 0, bit = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
    if ((axes >> axis & 1U) != 0) place |= (number >> bit++ & 1U) << axis;
  return place;
}

/// Merges two branches that split the same axes, without `axis`, into one that splits `axis` as
/// well.
BuildCell join_branches(BuildCell& a, BuildCell& b, unsigned axis) {
  BuildCell joined;
  joined.kind = CellKind::branch;
  joined.axes = a.axes | 1U << axis;
  joined.children.resize(2 * a.children.size());
  for (unsigned i = 0; i < a.children.size(); ++i) {
    const unsigned place = child_place(a.axes, i);
    joined.children[child_number(joined.axes, place)] = std::move(a.children[i]);
    joined.children[child_number(joined.axes, place | 1U << axis)] = std::move(b.children[i]);
  }
  return joined;
}

}  // namespace

BuildCell simplified(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range,
                     const std::array<double, 3>& cell_size, double max_error) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if ((axes >> axis & 1U) == 0) continue;
    const unsigned rest = axes & ~(1U << axis), pairs = 1U << std::popcount(rest);
    std::array<BuildCell, 4> joined;
    bool all = true;
    const auto pair = [&](unsigned i) {
      const unsigned place = child_place(rest, i);
      return std::pair(child_number(axes, place), child_number(axes, place | 1U << axis));
    };
    for (unsigned i = 0; i < pairs && all; ++i) {
      const auto [a, b] = pair(i);
      all = children[a].kind == children[b].kind && join(children[a], children[b], axis, range.child(axes, a),
                                                         range.child(axes, b), cell_size, max_error, joined[i]);
    }
    if (!all) continue;
    std::vector<BuildCell> fewer(pairs);
    for (unsigned i = 0; i < pairs; ++i) {
      const auto [a, b] = pair(i);
      if (children[a].kind != CellKind::branch) {
        fewer[i] = std::move(joined[i]);
        continue;
      }
      // Former cousins are siblings now, and may be merged in turn.
      BuildCell both = join_branches(children[a], children[b], axis);
      fewer[i] = simplified(std::move(both.children), both.axes, range.child(rest, i), cell_size, max_error);
    }
    children = std::move(fewer);
    axes = rest;
  }
  if (axes == 0) return std::move(children[0]);
  BuildCell branch;
  branch.kind = CellKind::branch;
  branch.axes = axes;
  branch.children = std::move(children);
  return branch;
}

namespace {

void count_cells(const BuildCell& cell, std::size_t& cells, std::size_t& leafs) {
  ++cells;
  leafs += cell.kind == CellKind::leaf;
  for (const BuildCell& child : cell.children) count_cells(child, cells, leafs);
}

void pack(const BuildCell& cell, std::size_t at, Asdf::Tree& tree) {
  switch (cell.kind) {
    case CellKind::leaf:
      tree.cells[at] = CellWord::leaf(tree.leafs.size());
      tree.leafs.push_back(LeafSamples::of(cell.corners));
      tree.greatest = std::max(tree.greatest, 32768 * tree.leafs.back().step);
      break;
    case CellKind::branch: {
      const std::size_t first = tree.cells.size();
      tree.cells[at] = CellWord::branch(first, cell.axes);
      tree.cells.resize(first + cell.children.size());
      for (std::size_t i = 0; i < cell.children.size(); ++i) pack(cell.children[i], first + i, tree);
      break;
    }
    default: tree.cells[at] = CellWord::of(cell.kind);
  }
}

}  // namespace

Asdf::Tree packed(const BuildCell& root) {
  std::size_t cells = 0, leafs = 0;
  count_cells(root, cells, leafs);
  if (cells > CellWord::most_cells)
    throw Error(ErrorKind::too_large, "voxel", "the distance field would have more than 2^27 cells");
  Asdf::Tree tree;
  tree.cells.reserve(cells);
  tree.leafs.reserve(leafs);
  tree.cells.resize(1);
  pack(root, 0, tree);
  return tree;
}

}  // namespace fieldfab
