#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include "exact_surface.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {

ExactSolid::ExactSolid(const Polyhedron& solid) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  if (solid.empty()) return;
  std::vector<Surface::Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  for (const Vec3& p : solid.vertices) points.emplace_back(p.x(), p.y(), p.z());
  for (const Polyhedron::Triangle& t : solid.triangles) faces.push_back({t[0], t[1], t[2]});
  pmp::repair_polygon_soup(points, faces);
  if (!pmp::orient_polygon_soup(points, faces) && !pmp::is_polygon_soup_a_polygon_mesh(faces))
    throw Error(ErrorKind::bad_input, "polyhedron", "its faces are not the surface of a solid");
  Surface::Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, faces, mesh);
  if (!CGAL::is_closed(mesh)) throw Error(ErrorKind::bad_input, "polyhedron", "its surface has holes");
  pmp::orient_to_bound_a_volume(mesh);
  surface_ = std::make_shared<Surface>(std::move(mesh), is_simple(solid));
}

Polyhedron ExactSolid::polyhedron() const { return empty() ? Polyhedron() : corners_of(surface_->mesh); }

ExactSolid ExactSolid::turned(const Eigen::Matrix3d& matrix) const {
  if (empty() || matrix.isIdentity(0)) return *this;
  Surface::Mesh mesh = surface_->mesh;
  for (const auto vertex : mesh.vertices()) {
    const Surface::Kernel::Point_3 p = mesh.point(vertex);
    const auto along = [&](Eigen::Index row) { return p.x() * matrix(row, 0) + p.y() * matrix(row, 1) + p.z() * matrix(row, 2); };
    mesh.point(vertex) = Surface::Kernel::Point_3(along(0), along(1), along(2));
  }
  return ExactSolid(std::make_shared<Surface>(std::move(mesh), surface_->simple));
}

ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress) {
  if (solids.empty()) return {};
  while (solids.size() > 1) {
    std::vector<ExactSolid> half(solids.size() / 2);
    parallel_for(half.size(), [&](std::size_t i) {
      progress.report(0, "joining solids");
      progress.check();
      half[i] = combined(solids[2 * i], solids[2 * i + 1], operation);
    });
    if (solids.size() % 2 == 1) half.push_back(std::move(solids.back()));
    solids = std::move(half);
  }
  return std::move(solids.front());
}

}  // namespace fieldfab
