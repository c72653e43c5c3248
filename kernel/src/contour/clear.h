/// Search for cells of a block that may hide some of the surface (docs/contouring.md, Complete).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fieldfab/field/surface_proof.h"
#include "lattice.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// Appends the direction that the surface faces at a point, if it is known.
inline void add_normal(const SurfacePoint& point, std::vector<Eigen::Vector3f>& normals) {
  if (!point.normal.isZero(0)) normals.push_back(point.normal);
}

/// A cell for which no proof was found.
struct UnclearCell {
  LatticePoint lower;
  int level;
  /// Has the solid's sign in the cell and `overlap` around it; null if the cell is not to be examined.
  FieldPtr field;
  bool folded = false;  ///< samples show more than one sheet; if false, only a proof is missing
};

/// Appends the cells from `first` to before `last` once more, moved to a place that is alike.
inline void append_moved(std::vector<UnclearCell>& cells, std::size_t first, std::size_t last, const LatticePoint& by) {
  for (; first < last; ++first) {
    UnclearCell cell = cells[first];
    cell.lower = moved(cell.lower, by[0], by[1], by[2]);
    cells.push_back(std::move(cell));
  }
}

/// Samples of a block.
struct BlockSamples {
  const float* values;                    ///< at 9x9x9 points, x fastest
  std::span<const std::uint8_t> corners;  ///< by cell (x fastest), as Leaf::corners
  std::span<const SurfacePoint> points;   ///< crossings of the surface with edges
};

/// Returns the cells, a voxel wide, of the block that may hide some of the surface. Sets `known` if
/// the Field returns any slopes.
std::vector<UnclearCell> unclear_cells(const Field& field, const Lattice& lattice, const LatticePoint& block,
                                       const BlockSamples& samples, bool& known);

}  // namespace fieldfab::contouring
