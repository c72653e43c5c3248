// Triangulation of a flat shape, by CGAL's constrained Delaunay triangulation.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>

#include "fieldfab/core/error.h"
#include "flat.h"

namespace fieldfab::openscad {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct FaceInfo {
  int around = -1;  ///< number of outlines around it
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const Region& region) {
  Triangulation triangulation;
  std::uint32_t count = 0;
  try {
    for (const Outline& outline : region.outlines) {
      std::vector<Triangulation::Vertex_handle> corners;
      for (const Vec2& p : outline) {
        const auto before = triangulation.number_of_vertices();
        const auto vertex = triangulation.insert({p.x(), p.y()});
        if (triangulation.number_of_vertices() > before) vertex->info() = count;
        ++count;
        corners.push_back(vertex);
      }
      for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] != corners[(i + 1) % corners.size()])
          triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw Error(ErrorKind::internal, "polygon", "outlines cross each other");
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (triangulation.dimension() < 2) return triangles;
  // From outside inwards; each crossed outline changes the side.
  std::deque<std::pair<Triangulation::Face_handle, int>> open{{triangulation.infinite_face(), 0}};
  while (!open.empty()) {
    const auto [face, around] = open.front();
    open.pop_front();
    if (face->info().around >= 0) continue;
    face->info().around = around;
    for (int i = 0; i < 3; ++i) {
      const auto other = face->neighbor(i);
      if (other->info().around >= 0) continue;
      if (face->is_constrained(i))
        open.emplace_back(other, around + 1);
      else
        open.emplace_front(other, around);
    }
  }
  for (const auto face : triangulation.finite_face_handles())
    if (face->info().around % 2 == 1)
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

}  // namespace fieldfab::openscad
