/// Triangles over a hole; private to the mesh folder.
#pragma once

#include <span>

#include "fieldfab/mesh/polyhedron.h"

namespace fieldfab {

/// Divides what a rim goes around: triangles of the numbers of its places, which they pass in the rim's own direction. Of all
/// ways to do so that with the least bends, then area (Liepa 2003, by CGAL). Nothing where none is found, or it would take long.
std::vector<Polyhedron::Triangle> triangles_over(std::span<const Vec3> rim);

}  // namespace fieldfab
