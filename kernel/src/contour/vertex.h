/// Where to put a vertex, from points of the surface and the planes that touch it there.
#pragma once

#include <Eigen/Core>
#include <span>

#include "fieldfab/core/geometry.h"

namespace fieldfab::contouring {

/// A point of the surface and its outward unit normal ("Hermite data"); the normal is zero where the Field has no gradient.
struct SurfacePoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
};

/// A vertex for the surface in a cell, and how far the farthest of the given tangent planes passes it, mm.
struct PlacedVertex {
  Vec3 position;
  double error;
  int directions;  ///< that the planes determine: 0 or 1 on a smooth surface, 2 on a crease, 3 in a corner
};

/// The point of `cell` that lies best on all tangent planes: on the crease where two meet, in the corner where three do, in the
/// middle of the points where all are one plane. It minimises the quadratic error (Garland and Heckbert; Ju et al. 2002, "Dual
/// contouring of Hermite data"), taking a direction into account only where that brings the vertex clearly closer.
PlacedVertex place_vertex(std::span<const SurfacePoint> points, const Box& cell);

}  // namespace fieldfab::contouring
