/// Curves in which the surface crosses the faces between leaf cells.
#pragma once

#include <limits>
#include <vector>

#include "octree.h"

namespace fieldfab::contouring {

inline constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// A curve across the face that two leafs share: from one vertex on the face's rim to another,
/// straight or with one bend. Seen from outside the `lower` leaf, the inside of the solid is to its
/// left; seen from outside the `upper` leaf, to its right.
struct FaceCurve {
  std::uint32_t lower, upper;  ///< indices of the leafs below and above the face along `axis`
  std::uint32_t from, to;      ///< indices into Curves::points
  std::uint32_t bend;          ///< index into Curves::bends, or no_vertex
  std::uint8_t axis;           ///< normal of the face
};

/// All curves of a contour, and their vertices.
struct Curves {
  std::vector<SurfacePoint> points;             ///< as located, one on each edge with a sign change
  std::vector<std::array<float, 3>> positions;  ///< positions of `points`, moved away from the ends of their edges
  std::vector<std::array<float, 3>> bends;      ///< strictly inside their faces
  /// By run of lower leafs (by_leaf.h), sorted by lower leaf.
  std::vector<std::vector<FaceCurve>> curves;
};

/// Finds the curves. Evaluates `solid` where a face is ambiguous, and to test whether a bend meets
/// the surface.
Curves trace_curves(const Field& solid, const Lattice& lattice, const Octree& octree, bool features,
                    Progress& progress);

}  // namespace fieldfab::contouring
