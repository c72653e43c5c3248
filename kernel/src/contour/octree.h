/// Octree of a contour. Blocks of 8x8x8 cells near the surface are sampled densely. Cells that are
/// not clear are halved. Cells whose surface one vertex reproduces are merged bottom-up into larger
/// leaf cells.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "fieldfab/contour/contour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "lattice.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// A cube that the surface crosses: one cell, or several merged cells whose surface it reproduces.
struct Leaf {
  LatticePoint lower;
  Eigen::Vector3f vertex;  ///< best position of the cell's vertex; set only if merged
  std::int32_t level;
  std::uint8_t corners;  ///< bit i: corner i is inside; bits of i are x (1), y (2), z (4)
  bool merged;
};

/// A sign change between neighbouring lattice points.
struct Crossing {
  std::uint8_t axis;
  /// Lower end of the edge, in cells from the lower corner of its block or division.
  std::array<std::uint8_t, 3> lower;
  bool lower_inside;
  SurfacePoint point;
};

/// A cell halved along x, y and z: its 3x3x3 lattice points and eight cells.
struct Division {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  LatticePoint lower;
  std::int32_t level = 0;                ///< of the eight cells
  std::uint32_t inside = 0;              ///< one bit per lattice point, x fastest
  std::vector<Crossing> crossings = {};  ///< on all edges
  /// By cell: index of the division of a cell that was halved
  /// again, or none.
  std::array<std::uint32_t, 8> parts{none, none, none, none, none, none, none, none};
  /// By cell: index of a cell that is a leaf, among the leafs of
  /// the block, or none.
  std::array<std::uint32_t, 8> leafs{none, none, none, none, none, none, none, none};

  [[nodiscard]] std::uint8_t corners(unsigned child) const;
};

/// 8x8x8 cells, a voxel wide, that contain some of the surface.
struct Block {
  static constexpr std::uint16_t no_leaf = std::numeric_limits<std::uint16_t>::max();

  LatticePoint lower;
  /// On edges whose lower end is below 8 on every axis, so that each edge has one block.
  std::vector<Crossing> crossings;
  std::vector<Leaf> leafs;  ///< leafs of whole cells and larger ones come first
  /// By cell (x fastest): index into leafs, or no_leaf; empty if all cells are leaf 0.
  std::vector<std::uint16_t> leaf_of;
  std::vector<Division> divisions;
  std::vector<std::uint32_t> division_of;  ///< by cell: index into divisions, or none; empty if no cell is halved
  std::uint32_t first_leaf = 0;            ///< index of leafs[0] among all leafs

  [[nodiscard]] std::uint16_t leaf_at(std::size_t cell) const {
    return leaf_of.empty() ? std::uint16_t{0} : leaf_of[cell];
  }
  [[nodiscard]] std::uint32_t division_at(std::size_t cell) const {
    return division_of.empty() ? Division::none : division_of[cell];
  }
  static std::size_t cell(int x, int y, int z) {
    return static_cast<std::size_t>(x + block_side * (y + block_side * z));
  }
};

/// Result of the search for a cell of some level: the cell itself if it is divided, or else the
/// smallest cell that contains it.
struct CellFound {
  const Block* block = nullptr;         ///< null if no surface is there
  std::uint32_t leaf = Division::none;  ///< index among all leafs
  int level = 0;
  bool divided = false;
};

/// Cells of a lattice that are contoured.
struct Extent {
  LatticePoint lower{0, 0, 0};
  std::int32_t side;        ///< of the cube of cells that get triangles, in finest cells
  std::int32_t margin = 0;  ///< width of the cells around the cube whose leafs are found, in finest cells
  int greatest_leaf;        ///< level of the largest cube of cells that may become one leaf

  /// All cells.
  static Extent whole(const Lattice& lattice) {
    return {.side = 1 << lattice.root_level(), .greatest_leaf = lattice.root_level()};
  }
  /// Returns whether the leaf, or the cell, with that lower corner gets triangles.
  [[nodiscard]] bool contains(const LatticePoint& cell) const {
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      inside = inside && cell[axis] >= lower[axis] && cell[axis] - lower[axis] < side;
    return inside;
  }
  /// Returns whether the leafs of a cube are found.
  [[nodiscard]] bool meets(const LatticePoint& cube, int level) const {
    bool met = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      met = met && cube[axis] + (1 << level) > lower[axis] - margin && cube[axis] < lower[axis] + side + margin;
    return met;
  }
};

struct Patch;
class BlockRefiner;

/// Leaf cells of a contour, with a search for the leaf at a cell.
class Octree {
 public:
  /// Samples the solid. Throws cancelled, too_large.
  Octree(const Field& solid, const Lattice& lattice, const Extent& extent, const ContourSettings& settings,
         Progress& progress);
  ~Octree();
  /// Whether most cells are not clear, so that a lattice of half the voxel costs less than an
  /// examination of each cell. No other member is valid then.
  [[nodiscard]] bool wants_half_voxel() const { return wants_half_voxel_; }
  /// Whether cells were halved so often that too many of their neighbours had to be halved too, as
  /// with a surface that is rough at every scale. No other member is valid then.
  [[nodiscard]] bool too_deep() const { return too_deep_; }

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] std::span<const Leaf> leafs() const { return {leafs_.get(), leaf_count_}; }
  [[nodiscard]] const Extent& extent() const { return extent_; }
  [[nodiscard]] const Certainty& certainty() const { return certainty_; }
  /// Cells that are not certain.
  [[nodiscard]] std::span<const UncertainCell> uncertain() const { return uncertain_; }
  /// Returns the eight blocks at and below `block`; each bit of the index is one block down its
  /// axis. A block without surface is null.
  [[nodiscard]] std::array<const Block*, 8> lower_neighbours(const Block& block) const;
  /// Finds the cell of that level (at most a voxel's) with that lower corner.
  [[nodiscard]] CellFound find(const LatticePoint& lower, int level) const;

 private:
  struct Node;
  void subdivide(const Field& solid, Progress& progress);
  void settle(std::span<Node> siblings) const;
  void sample_blocks(const ContourSettings& settings, Progress& progress);
  [[nodiscard]] bool half_voxel_pays(std::size_t folded, std::size_t crossed, std::size_t blocks,
                                     const ContourSettings& settings) const;
  void refine(std::span<Node* const> open, const ContourSettings& settings, std::size_t crossed, Progress& progress,
              std::vector<std::unique_ptr<BlockRefiner>>& refiners);
  int halve_unclear_cells(std::span<const std::size_t> active, const ContourSettings& settings, std::size_t crossed,
                          Progress& progress, std::vector<std::unique_ptr<BlockRefiner>>& refiners);
  void halve_neighbours(std::span<Node* const> open, std::vector<std::size_t> active, int finest,
                        const ContourSettings& settings, Progress& progress,
                        std::vector<std::unique_ptr<BlockRefiner>>& refiners);
  void merge_children(Node& node, const ContourSettings& settings);
  [[nodiscard]] std::vector<Leaf> merge_blocks(const ContourSettings& settings);
  void number_leafs(std::span<const Leaf> of_nodes);
  [[nodiscard]] const Block* block_at(const LatticePoint& lower) const;
  [[nodiscard]] std::uint64_t block_key(const LatticePoint& lower) const;
  [[nodiscard]] int block_root() const { return lattice_.voxel_level() + block_level; }

  const Lattice& lattice_;
  const Extent extent_;
  std::vector<Node> nodes_;  ///< breadth first: children after their parents
  std::vector<Block> blocks_;
  std::unique_ptr<Leaf[]> leafs_;
  std::size_t leaf_count_ = 0;
  std::vector<std::uint64_t> block_keys_;  ///< sorted; parallel to block_order_
  std::vector<std::uint32_t> block_order_;
  Certainty certainty_;
  std::vector<UncertainCell> uncertain_;
  bool wants_half_voxel_ = false, too_deep_ = false;
};

/// Sets `merged` to the corner signs of the cube that eight cells form, and returns true if their
/// signs make one surface patch. Returns false if merging would lose or join parts of the surface
/// (Ju et al. 2002, section 4.1: conditions on edge, face and cell midpoints).
bool merge_corners(const std::array<std::uint8_t, 8>& children, std::uint8_t& merged);

/// Returns whether a cell with these corner signs contains exactly one patch and no ambiguous face.
bool is_simple(std::uint8_t corners);
inline bool is_uniform(std::uint8_t corners) { return corners == 0 || corners == 255; }

/// Returns whether the signs at the 3x3 points of a halved face (bit u + 3 v) show the same curves
/// as its corners alone. A neighbour of the face's size agrees with them then.
bool is_plain_face(unsigned inside);

}  // namespace fieldfab::contouring
