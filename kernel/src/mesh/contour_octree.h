/// The octree of a contour: blocks of 8x8x8 cells near the surface, sampled densely, merged bottom-up into larger leaf cells.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "contour_lattice.h"
#include "contour_vertex.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/contour.h"

namespace fieldfab::contouring {

/// A cube crossed by the surface: the smallest cell, or one merged from cells whose surface it reproduces.
struct Leaf {
  LatticePoint lower;
  std::int32_t level = 0;
  std::uint8_t corners = 0;  ///< bit i: corner i is inside; bits of i are x (1), y (2), z (4)
  Vec3 vertex;               ///< the best place for the cell's vertex; only where level > 0
};

/// A sign change between neighbouring lattice points.
struct Crossing {
  std::uint8_t axis;
  std::array<std::uint8_t, 3> lower;  ///< the edge's lower end, in cells from the block's lower corner, each < 8
  bool lower_inside;
  SurfacePoint point;
};

/// 8x8x8 smallest cells with some of the surface in them.
struct Block {
  static constexpr std::uint16_t no_leaf = std::numeric_limits<std::uint16_t>::max();

  LatticePoint lower;
  std::vector<Crossing> crossings;  ///< on edges whose lower end is below 8 on every axis, so that each edge has one block
  std::vector<Leaf> leafs;
  std::vector<std::uint16_t> leaf_of;  ///< by cell (x fastest): index into leafs, or no_leaf; empty where all is leaf 0
  std::uint32_t first_leaf = 0;        ///< index of leafs[0] among all leafs

  [[nodiscard]] std::uint16_t leaf_at(int x, int y, int z) const {
    return leaf_of.empty() ? std::uint16_t{0} : leaf_of[cell(x, y, z)];
  }
  static std::size_t cell(int x, int y, int z) { return static_cast<std::size_t>(x + block_side * (y + block_side * z)); }
};

/// The leaf cells of a contour, and where each smallest cell lies among them.
class Octree {
 public:
  /// Samples the solid. Throws cancelled, too_large.
  Octree(const Field& solid, const Lattice& lattice, const ContourSettings& settings, Progress& progress);
  ~Octree();

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] const std::vector<Leaf>& leafs() const { return leafs_; }
  /// The eight blocks at and below `block` (bit set in the index: one block down that axis); null where no surface is.
  [[nodiscard]] std::array<const Block*, 8> lower_neighbours(const Block& block) const;

 private:
  struct Node;
  void subdivide(const Field& solid, const Lattice& lattice, Progress& progress);
  static void settle(std::span<Node> siblings, const Lattice& lattice);
  void sample_blocks(const Lattice& lattice, const ContourSettings& settings, Progress& progress);
  void merge_blocks(const Lattice& lattice, double max_error);
  void number_leafs();

  std::vector<Node> nodes_;  ///< breadth first: children after their parents
  std::vector<Block> blocks_;
  std::vector<Leaf> leafs_;
  std::vector<std::uint64_t> block_keys_;  ///< sorted; parallel to block_order_
  std::vector<std::uint32_t> block_order_;
};

/// Where an 8-cell neighbourhood's signs make one surface patch: the corners of the eight merged, or nothing where merging would
/// lose or join a part of the surface (Ju et al. 2002, section 5: conditions on edge, face and cell midpoints).
bool merge_corners(const std::array<std::uint8_t, 8>& children, std::uint8_t& merged);

/// Whether a cell with these corner signs holds exactly one patch with no ambiguous face.
bool is_simple(std::uint8_t corners);

}  // namespace fieldfab::contouring
