#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "exact_surface.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {

ExactSolid::ExactSolid(const Polyhedron& solid) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  if (solid.empty()) return;
  std::vector<Surface::Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  points.reserve(solid.vertices.size());
  faces.reserve(solid.triangles.size());
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
    const auto along = [&](Eigen::Index row) {
      return p.x() * matrix(row, 0) + p.y() * matrix(row, 1) + p.z() * matrix(row, 2);
    };
    mesh.point(vertex) = Surface::Kernel::Point_3(along(0), along(1), along(2));
  }
  return ExactSolid(std::make_shared<Surface>(std::move(mesh), surface_->simple));
}

bool ExactSolid::touches_itself() const { return !empty() && !surface_->simple; }

namespace {

/// Joins any two of several solids; if no pair can be joined, throws the last error.
void join_any_two(std::vector<ExactSolid>& solids, Operation operation, Progress& progress) {
  constexpr std::size_t most = 12;
  std::exception_ptr refusal;
  for (std::size_t i = 0; i < std::min(solids.size(), most); ++i)
    for (std::size_t j = i + 1; j < std::min(solids.size(), most); ++j) {
      progress.check();
      try {
        ExactSolid joined = combined(solids[i], solids[j], operation);
        if (joined.touches_itself()) continue;
        solids[i] = std::move(joined);
        solids.erase(solids.begin() + static_cast<std::ptrdiff_t>(j));
        return;
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        refusal = std::current_exception();
      }
    }
  if (refusal != nullptr) std::rethrow_exception(refusal);
  throw Error(ErrorKind::bad_input, "polyhedron", "the solids touch each other");
}

}  // namespace

ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress) {
  // Solids that only touch cannot be joined, or their result cannot be joined with others. They
  // wait for solids that may fill the gap between them.
  while (solids.size() > 2) {
    std::vector<std::optional<ExactSolid>> joined(solids.size() / 2);
    parallel_for(joined.size(), [&](std::size_t i) {
      progress.report(0, "joining solids");
      progress.check();
      try {
        ExactSolid both = combined(solids[2 * i], solids[2 * i + 1], operation);
        if (!both.touches_itself()) joined[i] = std::move(both);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
      }
    });
    std::vector<ExactSolid> next;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      if (joined[i]) {
        next.push_back(*std::move(joined[i]));
      } else {
        next.push_back(std::move(solids[2 * i]));
        next.push_back(std::move(solids[2 * i + 1]));
      }
    }
    if (solids.size() % 2 == 1) next.push_back(std::move(solids.back()));
    if (next.size() == solids.size()) join_any_two(next, operation, progress);
    std::rotate(next.begin(), next.begin() + 1, next.end());  // so that waiting solids meet others
    solids = std::move(next);
  }
  if (solids.empty()) return {};
  progress.check();
  return solids.size() == 1 ? solids.front() : combined(solids[0], solids[1], operation);
}

}  // namespace fieldfab
