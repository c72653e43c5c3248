/// Triangulation of a hole; private to the mesh folder.
#pragma once

#include <span>

#include "fieldfab/mesh/polyhedron.h"

namespace fieldfab {

/// Triangulates a rim: returns triangles of indices of its vertices, in the direction of the rim.
/// Minimises the bends, then the area (Liepa 2003, by CGAL). Returns an empty vector if no
/// triangulation is found or if it would take long.
std::vector<Polyhedron::Triangle> triangles_over(std::span<const Vec3> rim);

}  // namespace fieldfab
