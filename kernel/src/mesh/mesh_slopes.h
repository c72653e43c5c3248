/// How fast the signed distance to a mesh changes over a box; private to the mesh folder.
#pragma once

#include <functional>
#include <span>

#include "fieldfab/core/interval.h"
#include "triangle_tree.h"

namespace fieldfab {

/// A ball, and what is known of the distance in it.
struct DistanceBall {
  Vec3 centre;
  double reach;     ///< its radius, mm
  double distance;  ///< at the centre, negative inside
};

/// What a mesh winds around, as mesh_slopes() needs it.
struct Windings {
  /// Whether the sides of the triangles within `reach` of a point differ where, and only where, the number differs from 0.
  std::function<bool(const Vec3& point, double reach)> tell_sides;
  /// How often the mesh, closed with lids where it is open, winds around a point.
  std::function<int(const Vec3& point)> number;
};

/// Field::slopes() of the signed distance in a ball, which no lid of an open mesh turns over (see Windings::tell_sides).
void mesh_slopes(const TriangleTree& tree, const Windings& windings, const DistanceBall& ball, std::span<const Vec3> directions,
                 std::span<Interval> out);

}  // namespace fieldfab
