/// Lattice on which a Field is contoured: planes at exactly representable floats, cubes of 2^level
/// cells.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fieldfab/core/geometry.h"
#include "fieldfab/field/field.h"

namespace fieldfab::contouring {

/// A lattice point, or the lower corner of a cube, counted in finest cells from the origin of the
/// lattice.
using LatticePoint = std::array<std::int32_t, 3>;

/// A cube of a level is 1 << level finest cells wide. A block is block_side voxels wide.
inline constexpr int block_level = 3;
inline constexpr int block_side = 1 << block_level;

inline LatticePoint moved(const LatticePoint& point, int x, int y, int z) {
  return {point[0] + x, point[1] + y, point[2] + z};
}

/// Returns the lower corner of the child 0 to 7 (bits: upper half along x, y, z), of that level, of the cube at
/// `lower`.
inline LatticePoint child_of(const LatticePoint& lower, unsigned child, int level) {
  return moved(lower, static_cast<int>(child & 1U) << level, static_cast<int>(child >> 1 & 1U) << level,
               static_cast<int>(child >> 2) << level);
}

/// Equally spaced planes along three axes, each rounded to a float, with `bounds` strictly inside.
/// Cells are a voxel wide; they are halved down to the finest level if that is not enough. Voxels
/// are cubes, or parts of the cells between samples.
///
/// Because planes are floats, a vertex that is rounded to floats stays on its edge, in its face or
/// in its cell. So the guarantees of contour() hold for the coordinates that are written, not only
/// for those that were computed.
class Lattice {
 public:
  /// A voxel may be halved `depth` times, or less often if coordinates have too few floats for
  /// that. Throws bad_input if the bounds or the voxel are not finite and positive, or if too few
  /// floats lie across a voxel.
  Lattice(const Box& bounds, double voxel, int depth);
  /// Cells have the size of those of `samples`. Planes pass through all planes of `samples` that
  /// are a multiple of that size away from its origin.
  Lattice(const Box& bounds, const Sampling& samples, int depth);

  /// Returns the plane with that index across `axis`, mm.
  [[nodiscard]] double plane(int axis, std::int32_t index) const {
    return static_cast<float>(origin_[axis] + finest_[axis] * index);
  }
  [[nodiscard]] Box cube(const LatticePoint& lower, int level) const;
  /// Returns the cube of that level at `cells`, which counts cubes of that level from `first`.
  [[nodiscard]] Box plane_range(const LatticePoint& first, int level, const std::array<std::uint8_t, 3>& cells) const {
    return cube(moved(first, cells[0] << level, cells[1] << level, cells[2] << level), level);
  }
  /// Level of the cube that contains the whole lattice.
  [[nodiscard]] int root_level() const { return root_level_; }
  /// Shortest edge of a voxel, mm.
  [[nodiscard]] double voxel() const { return voxel_.minCoeff(); }
  /// Level of a cell that is a voxel wide; level 0 is the finest.
  [[nodiscard]] int voxel_level() const { return voxel_level_; }
  /// Shortest edge of a cube of that level, longest edge, and edge along an axis, mm, without
  /// rounding of the planes.
  [[nodiscard]] double side(int level) const { return std::ldexp(finest_.minCoeff(), level); }
  [[nodiscard]] double longest_side(int level) const { return std::ldexp(finest_.maxCoeff(), level); }
  [[nodiscard]] double side(int level, int axis) const { return std::ldexp(finest_[axis], level); }
  /// Minimum distance of a vertex from the ends of its edge, the rim of its face and the faces of
  /// its cell, mm, at that level.
  [[nodiscard]] double margin(int level) const { return std::max(std::ldexp(side(level), -11), 8 * float_step_); }
  /// Step between neighbouring floats at the farthest coordinate of the lattice, mm: the limit of
  /// any location.
  [[nodiscard]] double float_step() const { return float_step_; }

 private:
  void set_levels(const Box& bounds, int depth);

  Vec3 origin_;
  Vec3 voxel_, finest_;
  double float_step_;
  int voxel_level_;
  int root_level_;
};

}  // namespace fieldfab::contouring
