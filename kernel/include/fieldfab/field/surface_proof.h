/// Proofs about the surface in a box from the slopes of a Field (docs/contouring.md, Complete).
#pragma once

#include <vector>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// Proof about the surface in a box.
struct SurfaceProof {
  bool known = false;   ///< whether the Field has bounds of its slopes there
  bool folded = false;  ///< whether normals or gradients differ so much that the surface is not a graph
  /// whether the surface is the graph of a function over a plane, within the permitted steepness
  bool one_sheet = false;
  /// whether the values at the box's corners have one sign and are farther from zero than the value can change on the
  /// way to any point of the box, so that it contains no surface
  bool empty = false;
  /// bound of the difference between a value and that at the nearest corner of the cell; infinite if unknown
  double change = 0;
};

/// Permitted steepness of a sheet. A part that the corners of a cell do not detect is less than one cell deep. A thin
/// part attached to a detected one may be this many times as long as it is wide. Each halving of a voxel doubles the
/// permitted steepness, because a missed part is half as large.
inline constexpr double steepest_in_cells = 2;

/// Overlap of the examined region with neighbouring cells, as a fraction of the cell's side. Both cells at a common
/// face then see the same sheet.
inline constexpr double sheet_overlap = 0.125;

/// Tries to prove that the surface in `box` is one sheet: the graph of a function over a plane, nowhere steeper than
/// steepest_in_cells * 2^halvings. `field` must be valid in `box`. `normals` holds known normals of the surface there;
/// `side` is the edge of the cells, mm; `halvings` is the number of halvings from the voxel to these cells.
SurfaceProof prove_sheet(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals, double side,
                         int halvings);

/// Tries the proof for one cell after prove_sheet() failed, from the parts in which the Field's interval permits a
/// surface: from slabs across the axis that `normals` face most (of thin plates the other face lies in slabs of its
/// own), and from halves, which are halved up to `deep` times. The other parts lie on one side whatever their slopes,
/// so that each line along the axis still meets the surface once. Of no use for faceted Fields. May append to
/// `normals`; sets neither `change` nor `empty`.
SurfaceProof prove_sheet_by_parts(const Field& field, const Box& box, std::vector<Eigen::Vector3f>& normals,
                                  int halvings, int deep);

}  // namespace fieldfab
