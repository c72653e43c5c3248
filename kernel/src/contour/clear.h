/// Which cells of a block may hide some of the surface (docs/contouring.md, Complete).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fieldfab/field/surface_proof.h"
#include "lattice.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// Adds the direction that the surface faces at a point, where that is known.
inline void add_normal(const SurfacePoint& point, std::vector<Eigen::Vector3f>& normals) {
  if (!point.normal.isZero(0)) normals.push_back(point.normal);
}

/// A cell that nothing could be proved of.
struct UnclearCell {
  LatticePoint lower;
  int level;
  FieldPtr field;       ///< good in the cell and `overlap` about it; null where it is not to be looked into
  bool folded = false;  ///< it is seen that one sheet is not all; else only a proof is missing
};

/// What a block's samples tell.
struct BlockSamples {
  const float* values;                    ///< at 9x9x9 points, x fastest
  std::span<const std::uint8_t> corners;  ///< by cell (x fastest), as Leaf::corners
  std::span<const SurfacePoint> points;   ///< where the surface crosses edges
};

/// The block's cells, of a voxel, that are not clear: that may hide some of the surface. `known` is set where the Field tells any
/// slopes.
std::vector<UnclearCell> unclear_cells(const Field& field, const Lattice& lattice, const LatticePoint& block,
                                       const BlockSamples& samples, bool& known);

}  // namespace fieldfab::contouring
