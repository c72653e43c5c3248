/// Moving vertices out of their cells and faces onto sharp edges and corners, where the mesh allows it.
#pragma once

#include <vector>

#include "contour_vertex.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

/// A vertex that would lie better elsewhere: on a crease that pokes out of its cell or face.
struct Wish {
  std::uint32_t vertex;
  std::array<float, 3> target;
};

/// Grants every wish that keeps the mesh as valid as it was: a vertex moves only after each of its triangles, in its new place,
/// has been found, with exact predicates, to meet no other triangle but in their common vertex or edge, and not to be degenerate.
/// So a mesh without self-intersections stays one, whatever is wished for. Wishes should be short: about `reach` mm. The first
/// vertices of the mesh are those of `points`, whose normals tell a triangle that faces out from one that has folded over.
void grant(const std::vector<Wish>& wishes, double reach, const std::vector<SurfacePoint>& points, TriangleMesh& mesh,
           Progress& progress);

}  // namespace fieldfab::contouring
