#include "hole_lid.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>

namespace fieldfab {

std::vector<Polyhedron::Triangle> triangles_over(std::span<const Vec3> rim) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  constexpr std::size_t most = 1000;  // vertices
  if (rim.size() < 3 || rim.size() > most) return {};
  if (rim.size() == 3) return {{0, 1, 2}};  // frequent in triangle soups
  std::vector<Kernel::Point_3> points;
  points.reserve(rim.size());
  for (const Vec3& p : rim) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(found),
                                                           CGAL::parameters::do_not_use_cubic_algorithm(true));
  if (found.size() + 2 != rim.size()) return {};
  std::vector<Polyhedron::Triangle> triangles;
  triangles.reserve(found.size());
  for (const auto& t : found)
    triangles.push_back({static_cast<std::uint32_t>(t.first), static_cast<std::uint32_t>(t.second),
                         static_cast<std::uint32_t>(t.third)});
  const auto passes_backwards = [&](const Polyhedron::Triangle& t) {  // the edge from the first vertex to the second
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == 1 && t[(i + 1) % 3] == 0) return true;
    return false;
  };
  if (std::any_of(triangles.begin(), triangles.end(), passes_backwards))
    for (auto& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

}  // namespace fieldfab
