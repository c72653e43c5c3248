// inspect(): validity of a mesh by CGAL's Polygon Mesh Processing.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include "fieldfab/check/check.h"

namespace fieldfab {

MeshVerdict inspect(const TriangleMesh& mesh) {
  namespace processing = CGAL::Polygon_mesh_processing;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

  MeshVerdict verdict;
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  points.reserve(mesh.vertices.size());
  faces.reserve(mesh.triangles.size());
  for (const auto& p : mesh.vertices) points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : mesh.triangles) faces.push_back({t[0], t[1], t[2]});
  // Readers of the file merge vertices at equal positions.
  processing::merge_duplicate_points_in_polygon_soup(points, faces);
  processing::remove_isolated_points_in_polygon_soup(points, faces);
  verdict.manifold = processing::is_polygon_soup_a_polygon_mesh(faces);
  if (!verdict.manifold) return verdict;

  Surface surface;
  processing::polygon_soup_to_polygon_mesh(points, faces, surface);
  verdict.closed = CGAL::is_closed(surface);
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> crossings;
  processing::self_intersections(surface, std::back_inserter(crossings));
  verdict.self_intersections = crossings.size();
  for (const auto face : surface.faces())
    verdict.degenerate += processing::is_degenerate_triangle_face(face, surface) ? 1U : 0U;
  auto label = surface.add_property_map<Surface::Face_index, std::size_t>("f:component").first;
  verdict.components = processing::connected_components(surface, label);
  verdict.area = processing::area(surface);
  if (!verdict.closed) return verdict;
  verdict.volume = processing::volume(surface);
  // For CGAL, an inverted mesh bounds a volume, too: the complement.
  verdict.outward =
      surface.is_empty() ||
      (verdict.volume > 0 && (verdict.self_intersections > 0 || processing::does_bound_a_volume(surface)));
  return verdict;
}

}  // namespace fieldfab
