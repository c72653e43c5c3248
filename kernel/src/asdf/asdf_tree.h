/// Representation of an Asdf in memory, and cells during construction.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/asdf/asdf.h"

namespace fieldfab {

enum class CellKind : std::uint8_t { empty, filled, leaf, branch };

/// A cell in 32 bits: its kind, and the index of its children or samples. The children of a branch
/// are consecutive. The branch splits the axes in `axes` (bit 0 is x). Bit i of a child's number,
/// counted over the split axes in order, is set if the child is the upper part along that axis.
struct CellWord {
  std::uint32_t bits = 0;

  static CellWord of(CellKind kind) { return {static_cast<std::uint32_t>(kind)}; }
  static CellWord leaf(std::size_t samples) {
    return {static_cast<std::uint32_t>(samples << 2) | static_cast<std::uint32_t>(CellKind::leaf)};
  }
  static CellWord branch(std::size_t first_child, unsigned axes) {
    return {static_cast<std::uint32_t>(first_child << 5) | axes << 2 | static_cast<std::uint32_t>(CellKind::branch)};
  }
  [[nodiscard]] CellKind kind() const { return static_cast<CellKind>(bits & 3U); }
  [[nodiscard]] std::uint32_t samples() const { return bits >> 2; }
  [[nodiscard]] std::uint32_t first_child() const { return bits >> 5; }
  [[nodiscard]] unsigned axes() const { return bits >> 2 & 7U; }

  static constexpr std::size_t most_cells = std::size_t{1} << 27;
};

/// Distances at the corners of a leaf (bits of the index: x 1, y 2, z 4) in steps of `step`. A
/// negative distance is never stored as 0.
struct LeafSamples {
  float step;
  std::array<std::int16_t, 8> distance;

  static LeafSamples of(const std::array<float, 8>& distances);
  [[nodiscard]] float corner(std::size_t i) const { return step * static_cast<float>(distance[i]); }
};

struct Asdf::Tree {
  std::vector<CellWord> cells;
  std::vector<LeafSamples> leafs;
  float greatest = 0;  ///< greatest magnitude of a value in a leaf
};

/// The lattice cells that a cell of the tree covers.
struct LatticeRange {
  std::array<int, 3> first, count;

  /// Number of cells in the lower part along `axis`: the half, rounded down, as in kokopelli's
  /// format.
  [[nodiscard]] int lower_count(int axis) const { return count[static_cast<std::size_t>(axis)] / 2; }
  [[nodiscard]] LatticeRange child(unsigned axes, unsigned number) const;
  /// Axes with more than one cell.
  [[nodiscard]] unsigned divisible() const;
  /// Number of cells along the longest axis.
  [[nodiscard]] int longest() const { return std::max({count[0], count[1], count[2]}); }
};

/// A cell during construction or change of a tree.
struct BuildCell {
  CellKind kind = CellKind::empty;
  unsigned axes = 0;
  float slack = 0;  ///< upper bound of the distance of the interpolation from merged samples, mm
  std::array<float, 8> corners{};
  std::vector<BuildCell> children;
};

/// Lower bound of the length of the gradient in a leaf with sides of `size` mm. It converts
/// differences of values to mm: the surfaces of two functions that differ by d are at most d /
/// steepness apart.
double steepness(const std::array<float, 8>& corners, const std::array<double, 3>& size);

/// Merges equal children, one axis at a time (Alg. 2.1). `children` are those of a branch over
/// `range` that splits `axes`.
BuildCell simplified(std::vector<BuildCell> children, unsigned axes, const LatticeRange& range,
                     const std::array<double, 3>& cell_size, double max_error);

/// Packs the cells; throws too_large beyond CellWord::most_cells.
Asdf::Tree packed(const BuildCell& root);

}  // namespace fieldfab
