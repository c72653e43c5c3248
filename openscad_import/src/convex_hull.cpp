// Convex hull of points, by CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "polyhedron.h"

namespace fieldfab::openscad {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
}  // namespace

Polyhedron convex_hull(std::span<const Vec3> points) {
  std::vector<Point> input;
  input.reserve(points.size());
  Box box{Vec3::Constant(std::numeric_limits<double>::infinity()),
          Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const Vec3& p : points) {
    input.emplace_back(p.x(), p.y(), p.z());
    box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
  }
  if (input.size() < 4) return {};
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  Polyhedron result;
  for (const auto vertex : hull.vertices()) {
    const Point& p = hull.point(vertex);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : hull.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto vertex : hull.vertices_around_face(hull.halfedge(face)))
      corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    for (std::size_t i = 2; i < corners.size(); ++i)
      result.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  if (result.triangles.size() < 4) return {};
  double volume = 0;
  for (const Triangle& t : result.triangles)
    volume += result.vertices[t[0]].dot(result.vertices[t[1]].cross(result.vertices[t[2]]));
  const double size = box.diagonal();
  if (!(volume > 1e-12 * size * size * size)) return {};  // flat
  return result;
}

}  // namespace fieldfab::openscad
