/// The lattice a Field is contoured on: planes at exactly representable floats, cubes of 2^level cells.
#pragma once

#include <array>
#include <cstdint>

#include "fieldfab/core/geometry.h"

namespace fieldfab::contouring {

/// A lattice point or the lower corner of a cell, in cells from the lattice's origin.
using LatticePoint = std::array<std::int32_t, 3>;

/// Cells of a lattice cube along an axis, and its level: side == 1 << level.
inline constexpr int block_level = 3;
inline constexpr int block_side = 1 << block_level;

/// Equally spaced planes along three axes, each rounded to a float, with the whole `bounds` strictly inside.
///
/// Because planes are floats, a vertex that is rounded to floats stays on its edge, in its face or in its cell: the guarantees
/// of contour() hold for the coordinates that are written, not only for those that were computed.
class Lattice {
 public:
  /// Throws bad_input where bounds or voxel are not finite and positive, or a cell would have too few floats across it.
  Lattice(const Box& bounds, double voxel);

  /// The plane of that index across `axis`, mm.
  [[nodiscard]] double plane(int axis, std::int32_t index) const { return static_cast<float>(origin_[axis] + voxel_ * index); }
  [[nodiscard]] Box cube(const LatticePoint& lower, int level) const;
  /// Level of the cube that holds everything.
  [[nodiscard]] int root_level() const { return root_level_; }
  [[nodiscard]] double voxel() const { return voxel_; }
  /// How far a vertex keeps from the ends of its edge, the rim of its face, the faces of its cell, mm.
  [[nodiscard]] double margin() const { return margin_; }
  /// The step between neighbouring floats at the lattice's farthest coordinate, mm: nothing can be located more finely.
  [[nodiscard]] double float_step() const { return float_step_; }

 private:
  Vec3 origin_;
  double voxel_;
  double margin_, float_step_;
  int root_level_ = block_level;
};

}  // namespace fieldfab::contouring
