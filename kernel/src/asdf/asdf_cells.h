/// Cells from values at lattice points, for construction from Fields and import of volumes (Keeter
/// Algs 2.1, 5.1).
#pragma once

#include <atomic>

#include "asdf_tree.h"

namespace fieldfab {

inline constexpr int block_side = 8;  ///< cells per axis that are processed together

/// Values at the lattice points of a range, and the strides between neighbours along each axis.
struct LatticeSamples {
  const float* value;
  const std::uint16_t* inside;  ///< one word per row along x: bit `shift` is set if its first value is below 0
  unsigned shift;
  std::array<std::size_t, 3> stride;

  [[nodiscard]] const float* row(int j, int k) const {
    return value + stride[1] * static_cast<std::size_t>(j) + stride[2] * static_cast<std::size_t>(k);
  }
  [[nodiscard]] LatticeSamples from(const LatticeRange& whole, const LatticeRange& part) const;
  /// Value at a corner (bits: x, y, z) of a range with `count` cells.
  [[nodiscard]] float corner(std::size_t number, const std::array<int, 3>& count) const;
};

/// Values of a block of at most block_side cells per axis, x fastest, and a bit for each value that
/// is inside.
struct BlockSamples {
  static constexpr std::size_t most_rows = (block_side + 1) * (block_side + 1), most = most_rows * (block_side + 1);
  std::array<float, most> value;
  std::array<std::uint16_t, most_rows> inside;

  /// Returns all samples, once the values are set.
  LatticeSamples all(const std::array<std::size_t, 3>& points);
};

/// Makes cells over a lattice, with at most `memory` bytes. Member functions may be called from
/// several threads at once.
class CellMaker {
 public:
  CellMaker(const Box& region, const std::array<int, 3>& lattice, double max_error, bool merge_leafs,
            std::uintmax_t memory);

  /// Returns the cells of a block of samples: one leaf if that suffices, otherwise built bottom-up.
  BuildCell block(const LatticeSamples& samples, const LatticeRange& range);
  /// Returns a branch with these children, or the result of merging them.
  BuildCell joined(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range);
  /// Tries to represent `count` cells, `size` mm in all, as one leaf: interpolation must reproduce
  /// each sample within max_error, and its sign.
  bool one_leaf(const LatticeSamples& samples, const std::array<int, 3>& count, const std::array<double, 3>& size,
                BuildCell& leaf) const;

  [[nodiscard]] bool merges() const { return merge_leafs_ && max_error_ > 0; }
  [[nodiscard]] LatticeRange whole() const { return {{0, 0, 0}, count_}; }
  [[nodiscard]] std::array<double, 3> size_of(const LatticeRange& range) const {
    return {range.count[0] * size_[0], range.count[1] * size_[1], range.count[2] * size_[2]};
  }
  /// Position of a plane of lattice points, mm.
  [[nodiscard]] double plane(int axis, int index) const;
  [[nodiscard]] Box box(const LatticeRange& range) const;
  /// Fraction of the lattice that a range covers.
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
