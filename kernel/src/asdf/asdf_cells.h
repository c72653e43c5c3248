/// From values at lattice points to cells: what building from Fields and importing volumes share (Keeter Algs 2.1, 5.1).
#pragma once

#include <atomic>

#include "asdf_tree.h"

namespace fieldfab {

inline constexpr int block_side = 8;  ///< cells an axis that are looked at together

/// The values at the lattice points of a range, and how far apart neighbours are along each axis.
struct LatticeSamples {
  const float* value;
  const std::uint16_t* inside;  ///< a row along x each: bit `shift` says that its first value is below 0
  unsigned shift;
  std::array<std::size_t, 3> stride;

  [[nodiscard]] const float* row(int j, int k) const {
    return value + stride[1] * static_cast<std::size_t>(j) + stride[2] * static_cast<std::size_t>(k);
  }
  [[nodiscard]] LatticeSamples from(const LatticeRange& whole, const LatticeRange& part) const;
  /// At a corner of a range with so many cells (bits: x, y, z).
  [[nodiscard]] float corner(std::size_t number, const std::array<int, 3>& count) const;
};

/// The values of a block of at most block_side cells an axis, x fastest, and which of them are inside.
struct BlockSamples {
  static constexpr std::size_t most_rows = (block_side + 1) * (block_side + 1), most = most_rows * (block_side + 1);
  std::array<float, most> value;
  std::array<std::uint16_t, most_rows> inside;

  /// All of them, once the values are set.
  LatticeSamples all(const std::array<std::size_t, 3>& points);
};

/// Makes cells over a lattice, as long as they take no more than `memory` bytes. Its members may be called from many threads.
class CellMaker {
 public:
  CellMaker(const Box& region, const std::array<int, 3>& lattice, double max_error, bool merge_leafs, std::uintmax_t memory);

  /// The cells of a block from its samples: bottom-up, but for what is one leaf at once.
  BuildCell block(const LatticeSamples& samples, const LatticeRange& range);
  /// A branch with these children, or what they join to.
  BuildCell joined(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range);
  /// Tries `count` cells of `size` mm in all as one leaf: interpolation must reproduce every sample to max_error, and its sign.
  bool one_leaf(const LatticeSamples& samples, const std::array<int, 3>& count, const std::array<double, 3>& size,
                BuildCell& leaf) const;

  [[nodiscard]] bool merges() const { return merge_leafs_ && max_error_ > 0; }
  [[nodiscard]] LatticeRange whole() const { return {{0, 0, 0}, count_}; }
  [[nodiscard]] std::array<double, 3> size_of(const LatticeRange& range) const {
    return {range.count[0] * size_[0], range.count[1] * size_[1], range.count[2] * size_[2]};
  }
  /// Where a plane of lattice points is.
  [[nodiscard]] double plane(int axis, int index) const;
  [[nodiscard]] Box box(const LatticeRange& range) const;
  /// What share of the lattice a range is.
  [[nodiscard]] double share(const LatticeRange& range) const {
    return static_cast<double>(range.count[0]) / count_[0] * range.count[1] / count_[1] * range.count[2] / count_[2];
  }

 private:
  Box region_;
  std::array<int, 3> count_{};
  std::array<double, 3> size_{};
  double max_error_;
  bool merge_leafs_;
  std::uintmax_t memory_;
  std::atomic<std::size_t> cells_{0};
};

}  // namespace fieldfab
