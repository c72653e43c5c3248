/// Surface of an exact solid; private to the mesh folder, for files that include CGAL.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "corners_of.h"
#include "fieldfab/mesh/exact_solid.h"

namespace fieldfab {

struct ExactSolid::Surface {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  CGAL::Bbox_3 box;
  bool simple;  ///< known neither to intersect nor to touch itself

  Surface(Mesh whole, bool is_simple) : mesh(std::move(whole)), simple(is_simple) {
    for (const auto vertex : mesh.vertices()) box += mesh.point(vertex).bbox();
  }
};

}  // namespace fieldfab
