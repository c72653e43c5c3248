// Surfaces in double precision: whether they bound a solid, and conversion to single precision such
// that they still do.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "corners_of.h"
#include "fieldfab/mesh/exact_solid.h"

namespace fieldfab {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Returns false if an edge has more than two faces.
bool to_surface(const Polyhedron& surface, Mesh& mesh) {
  std::vector<Kernel::Point_3> points;
  points.reserve(surface.vertices.size());
  for (const Vec3& p : surface.vertices) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> faces;
  faces.reserve(surface.triangles.size());
  for (const Polyhedron::Triangle& t : surface.triangles) faces.push_back({t[0], t[1], t[2]});
  if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) return false;
  pmp::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return true;
}

/// Height of a triangle over its longest edge, which begins at the first corner.
double height(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / (b - a).norm(); }

/// Flips the longest edge of a triangle whose opposite corner nearly lies on it, if both new
/// triangles face the same way as the old neighbour and neither is as narrow.
bool turn_longest_edge(Mesh& mesh, Mesh::Face_index face, double narrowest) {
  auto longest = mesh.halfedge(face);
  const auto length = [&](Mesh::Halfedge_index half) {
    return CGAL::squared_distance(mesh.point(mesh.source(half)), mesh.point(mesh.target(half)));
  };
  for (const auto half : mesh.halfedges_around_face(mesh.halfedge(face)))
    if (length(half) > length(longest)) longest = half;
  const auto opposite = mesh.opposite(longest);
  const auto corner = mesh.target(mesh.next(longest)), beyond = mesh.target(mesh.next(opposite));
  const Vec3 a = rounded(mesh.point(mesh.source(longest))), b = rounded(mesh.point(mesh.target(longest))),
             c = rounded(mesh.point(corner)), d = rounded(mesh.point(beyond));
  const double narrow = height(a, b, c);
  if (!(narrow < narrowest) || mesh.halfedge(corner, beyond).is_valid()) return false;
  const Vec3 there = (a - b).cross(d - b), one = (d - c).cross(b - c), other = (c - d).cross(a - d);
  if (!(one.dot(there) > 0 && other.dot(there) > 0)) return false;
  const auto least = [](const Vec3& area, const Vec3& p, const Vec3& q, const Vec3& r) {
    return area.norm() / std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
  };
  if (!(std::min(least(one, c, d, b), least(other, d, c, a)) > narrow)) return false;
  CGAL::Euler::flip_edge(longest, mesh);
  return true;
}

/// Returns a surface without edges shorter than `narrowest` mm and without triangles narrower than
/// that: collapses and flips edges as far as the surface stays valid.
Polyhedron without_slivers(const Polyhedron& surface, double narrowest) {
  Mesh mesh;
  if (!to_surface(surface, mesh)) return surface;
  const std::vector<Mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  for (const auto edge : edges) {
    if (mesh.is_removed(edge)) continue;
    const auto half = mesh.halfedge(edge);
    const double square = CGAL::squared_distance(mesh.point(mesh.source(half)), mesh.point(mesh.target(half)));
    if (square < narrowest * narrowest && CGAL::Euler::does_satisfy_link_condition(edge, mesh))
      CGAL::Euler::collapse_edge(edge, mesh);
  }
  constexpr int rounds = 4;
  bool turned = true;
  for (int round = 0; round < rounds && turned; ++round) {
    turned = false;
    for (const auto face : mesh.faces()) turned = turn_longest_edge(mesh, face, narrowest) || turned;
  }
  pmp::remove_degenerate_faces(mesh);
  mesh.collect_garbage();
  return corners_of(mesh);
}

}  // namespace

bool is_simple(const Polyhedron& surface) {
  Mesh mesh;
  return to_surface(surface, mesh) && !pmp::does_self_intersect(mesh);
}

bool bounds_a_solid(const Polyhedron& surface) {
  Mesh mesh;
  return to_surface(surface, mesh) && CGAL::is_closed(mesh) && !pmp::does_self_intersect(mesh) &&
         pmp::is_outward_oriented(mesh) && pmp::does_bound_a_volume(mesh);
}

std::optional<TriangleMesh> in_single_precision(const Polyhedron& surface) {
  const auto if_valid = [](const Polyhedron& candidate) -> std::optional<TriangleMesh> {
    const TriangleMesh mesh = to_mesh(welded(to_polyhedron(to_mesh(candidate))));
    return bounds_a_solid(to_polyhedron(mesh)) ? std::optional(mesh) : std::nullopt;
  };
  constexpr double narrowest = 1e-6;  // relative to the size; rounding could invert narrower triangles
  if (auto mesh = if_valid(surface)) return mesh;
  return if_valid(without_slivers(surface, narrowest * surface.bounds().diagonal()));
}

}  // namespace fieldfab
