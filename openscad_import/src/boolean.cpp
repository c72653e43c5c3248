// Unions, intersections and differences of polyhedra with exact arithmetic, by CGAL: for hulls, shadows and sums of what is
// joined from parts. What is only shown or milled never comes here.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include "fieldfab/core/error.h"
#include "polyhedron.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh to_exact(const Polyhedron& solid) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  for (const Vec3& p : solid.vertices) points.emplace_back(p.x(), p.y(), p.z());
  for (const Triangle& t : solid.triangles) faces.push_back({t[0], t[1], t[2]});
  pmp::repair_polygon_soup(points, faces);
  if (!pmp::orient_polygon_soup(points, faces) && !pmp::is_polygon_soup_a_polygon_mesh(faces))
    throw Error(ErrorKind::bad_input, "polyhedron", "its faces are not the surface of a solid");
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, faces, mesh);
  if (!CGAL::is_closed(mesh)) throw Error(ErrorKind::bad_input, "polyhedron", "its surface has holes");
  pmp::orient_to_bound_a_volume(mesh);
  return mesh;
}

Polyhedron from_exact(const Mesh& mesh) {
  Polyhedron solid;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const auto vertex : mesh.vertices()) {
    const auto& p = mesh.point(vertex);
    number[vertex.idx()] = static_cast<std::uint32_t>(solid.vertices.size());
    solid.vertices.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for (const auto face : mesh.faces()) {
    Triangle t{};
    std::size_t i = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) t[i++ % 3] = number[vertex.idx()];
    solid.triangles.push_back(t);
  }
  return solid;
}

}  // namespace

bool crosses_itself(const Polyhedron& solid) {
  using Quick = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Quick::Point_3> points;
  for (const Vec3& p : solid.vertices) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> faces;
  for (const Triangle& t : solid.triangles) faces.push_back({t[0], t[1], t[2]});
  CGAL::Surface_mesh<Quick::Point_3> mesh;
  if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) return true;
  pmp::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return pmp::does_self_intersect(mesh);
}

Polyhedron combined(const Polyhedron& a, const Polyhedron& b, Operation operation) {
  if (a.empty() || b.empty()) {
    if (operation == Operation::intersect) return {};
    return a.empty() && operation == Operation::unite ? b : a;
  }
  try {
    Mesh one = to_exact(a), two = to_exact(b), result;
    const auto throwing = pmp::parameters::throw_on_self_intersection(true);
    bool valid = false;
    if (operation == Operation::unite) valid = pmp::corefine_and_compute_union(one, two, result, throwing);
    if (operation == Operation::intersect) valid = pmp::corefine_and_compute_intersection(one, two, result, throwing);
    if (operation == Operation::subtract) valid = pmp::corefine_and_compute_difference(one, two, result, throwing);
    if (valid) return from_exact(result);
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    throw Error(ErrorKind::bad_input, "polyhedron", "its surface crosses itself");
  }
  throw Error(ErrorKind::bad_input, "polyhedron", "what comes of joining two solids is not the surface of a solid");
}

}  // namespace fieldfab::openscad
