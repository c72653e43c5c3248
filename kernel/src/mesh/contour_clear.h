/// What can be proved of the surface in a cube of cells (docs/contouring.md, Complete).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contour_lattice.h"
#include "contour_vertex.h"
#include "fieldfab/field/field.h"

namespace fieldfab::contouring {

/// What is proved of the surface in a box from the Field's slopes.
struct Proof {
  bool known = false;      ///< whether the Field tells its slopes there at all
  bool folded = false;     ///< normals or gradients of it are seen to differ so much that it is not such a graph
  bool one_sheet = false;  ///< it is the graph of a function over a plane, and nowhere steeper than is allowed
  double change = 0;       ///< the value differs from that at the nearest corner of a cell by no more; infinite where not known
};

/// The part of the surface that is lost where a cell's corners do not see it is less than a cell deep; but a thin part that grows
/// out of what is seen may be as long as this many times its width. A voxel shows parts that are steeper only after halving; with
/// each time twice as steep ones are allowed, since what may be lost is half as large.
inline constexpr double steepest_in_voxels = 2;

/// How far about a cell it is looked, as a part of its side, so that what one cell takes for the top of something and its
/// neighbour for the bottom is found by both.
inline constexpr double overlap = 0.125;

/// Adds the direction that the surface faces at a point, where that is known.
inline void add_normal(const SurfacePoint& point, std::vector<Eigen::Vector3f>& normals) {
  if (!point.normal.isZero(0)) normals.push_back(point.normal);
}

/// Looks at `box`, for which `field` must be good. `normals` are those of the surface there, as far as known; `side` is the edge
/// of the cells, in mm, and `halvings` how often a voxel was halved for them.
Proof look(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side, int halvings);

/// The same of one cell that look() proved nothing of: of those parts of it that the Field's interval leaves room
/// for a surface in. Where the others are of one side, whatever their slopes, each line along the axis still meets the surface
/// once. `change` is left out; adds to `normals`. Halves
/// are halved again `deep` times.
Proof look_closer(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, int halvings, int deep);

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
