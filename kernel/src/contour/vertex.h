/// Placement of a vertex, given points of the surface and the tangent planes there.
#pragma once

#include <Eigen/Core>
#include <span>

#include "fieldfab/core/geometry.h"

namespace fieldfab::contouring {

/// A point of the surface and its outward unit normal (Hermite data); the normal is zero if the
/// Field has no gradient.
struct SurfacePoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
};

/// A vertex for the surface in a cell, and its greatest distance from the given tangent planes, mm.
struct PlacedVertex {
  Vec3 position;
  double error;
  /// Number of directions that the planes determine: 0 or 1 on a smooth surface, 2 on a crease, 3
  /// in a corner.
  int directions;
};

/// Returns the point of `cell` with the least distance from all tangent planes: on the crease of two planes, in the
/// corner of three, in the middle of the points of one plane. Minimises the sum of squared distances (the quadric error
/// metric of Garland and Heckbert 1997, the quadratic error function of Ju et al. 2002, "Dual contouring of Hermite
/// data"). Uses a direction only if that brings the vertex clearly closer.
PlacedVertex place_vertex(std::span<const SurfacePoint> points, const Box& cell);

}  // namespace fieldfab::contouring
