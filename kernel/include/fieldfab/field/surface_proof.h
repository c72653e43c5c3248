/// What the slopes of a Field prove about its surface in a box (docs/contouring.md, Complete).
#pragma once

#include <vector>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// What is proved of the surface in a box from the Field's slopes.
struct SurfaceProof {
  bool known = false;      ///< whether the Field tells its slopes there at all
  bool folded = false;     ///< normals or gradients of it are seen to differ so much that it is not such a graph
  bool one_sheet = false;  ///< it is the graph of a function over a plane, and nowhere steeper than is allowed
  double change = 0;       ///< the value differs from that at the nearest corner of a cell by no more; infinite where not known
};

/// The part of the surface that is lost where a cell's corners do not see it is less than a cell deep; but a thin part that grows
/// out of what is seen may be as long as this many times its width. A voxel shows parts that are steeper only after halving; with
/// each time twice as steep ones are allowed, since what may be lost is half as large.
inline constexpr double steepest_in_cells = 2;

/// How far about a cell it is looked, as a part of its side, so that what one cell takes for the top of something and its
/// neighbour for the bottom is found by both.
inline constexpr double sheet_overlap = 0.125;

/// Tries to prove that the surface in `box`, for which `field` must be good, is one sheet: the graph of a function over a plane,
/// nowhere steeper than steepest_in_cells * 2^halvings. `normals` are those of the surface there, as far as known; `side` is the
/// edge of the cells, in mm, and `halvings` how often a voxel was halved for them.
SurfaceProof prove_sheet(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side, int halvings);

/// The same for one cell where prove_sheet() failed, from those parts of it in which the Field's interval leaves room for a
/// surface. Where the other parts are of one side, whatever their slopes, each line along the axis still meets the surface once.
/// Halves are halved again `deep` times. Adds to `normals`, and leaves out `change`.
SurfaceProof prove_sheet_by_parts(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, int halvings,
                                  int deep);

}  // namespace fieldfab
