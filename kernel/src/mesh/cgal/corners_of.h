/// Conversion of CGAL's surfaces to Polyhedra; private to the mesh folder, for files that include
/// CGAL.
#pragma once

#include "fieldfab/mesh/polyhedron.h"

namespace fieldfab {

template <class Point>
Vec3 rounded(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

template <class AnyMesh>
Polyhedron corners_of(const AnyMesh& mesh) {
  Polyhedron solid;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const auto vertex : mesh.vertices()) {
    number[vertex.idx()] = static_cast<std::uint32_t>(solid.vertices.size());
    solid.vertices.push_back(rounded(mesh.point(vertex)));
  }
  for (const auto face : mesh.faces()) {
    Polyhedron::Triangle t{};
    std::size_t i = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) t[i++ % 3] = number[vertex.idx()];
    solid.triangles.push_back(t);
  }
  return solid;
}

}  // namespace fieldfab
