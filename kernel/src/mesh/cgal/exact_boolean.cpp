// Booleans of two exact solids, by CGAL's corefinement.
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version_macros.h>

#include <Eigen/Geometry>

#include "exact_surface.h"
#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

#if CGAL_VERSION_MAJOR < 6
using Wanted = boost::optional<Mesh*>;
#else
using Wanted = std::optional<Mesh*>;
#endif

/// A face, as far as it matters for the faces that it meets.
struct Face {
  Vec3 point, normal;
  double size;

  [[nodiscard]] bool is_in_plane_of(const Face& other) const {
    constexpr double nearly = 1e-9;
    return normal.cross(other.normal).squaredNorm() < nearly * nearly &&
           std::abs(normal.dot(other.point - point)) < nearly * (size + other.size);
  }
};
using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face>;

std::vector<FaceBox> face_boxes(const Mesh& mesh) {
  std::vector<FaceBox> boxes;
  boxes.reserve(mesh.number_of_faces());
  for (const auto face : mesh.faces()) {
    CGAL::Bbox_3 box;
    std::array<Vec3, 3> corner;
    std::size_t i = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      corner[i++ % 3] = rounded(mesh.point(vertex));
      box += mesh.point(vertex).bbox();
    }
    const Vec3 u = corner[1] - corner[0], v = corner[2] - corner[0];
    boxes.emplace_back(box, Face{corner[0], u.cross(v).normalized(), u.norm() + v.norm()});
  }
  return boxes;
}

/// Throws too_large if there is too much work: each pair of faces that intersect costs exact
/// constructions, and a coplanar pair many.
void require_little_work(const Mesh& a, const Mesh& b) {
  constexpr std::size_t most_meeting = 2'000'000, most_in_one_plane = 20'000;
  std::size_t meeting = 0, in_one_plane = 0;
  std::vector<FaceBox> one = face_boxes(a), two = face_boxes(b);
  CGAL::box_intersection_d(one.begin(), one.end(), two.begin(), two.end(), [&](const FaceBox& f, const FaceBox& g) {
    if (f.info().is_in_plane_of(g.info())) ++in_one_plane;
    if (++meeting > most_meeting || in_one_plane > most_in_one_plane)
      throw Error(ErrorKind::too_large, "polyhedron", "too many faces cross or lie in one plane");
  });
}

/// Whether a surface touches itself at a vertex, as results of corefinement can: a vertex with two
/// rings of faces, or two vertices at the same position.
bool touches_itself(const Mesh& mesh) {
  std::vector<Mesh::Halfedge_index> rounds;
  pmp::non_manifold_vertices(mesh, std::back_inserter(rounds));
  if (!rounds.empty()) return true;
  struct Corner {
    Mesh::Vertex_index vertex;
    Vec3 place;
    double along;
  };
  // Direction along which different corners usually have different coordinates.
  const Vec3 way(0.61803, 0.54931, 0.56226);
  std::vector<Corner> corners;
  corners.reserve(mesh.number_of_vertices());
  double farthest = 0;
  for (const auto vertex : mesh.vertices()) {
    const Vec3 place = rounded(mesh.point(vertex));
    corners.push_back({vertex, place, way.dot(place)});
    farthest = std::max(farthest, place.cwiseAbs().maxCoeff());
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.along < b.along; });
  const double rounding = 1e-12 * farthest;
  for (auto a = corners.begin(); a != corners.end(); ++a)
    for (auto b = a + 1; b != corners.end() && b->along - a->along <= 2 * rounding; ++b)
      if ((b->place - a->place).norm() <= rounding && mesh.point(a->vertex) == mesh.point(b->vertex)) return true;
  return false;
}

}  // namespace

ExactSolid combined(const ExactSolid& a, const ExactSolid& b, Operation operation) {
  using Surface = ExactSolid::Surface;
  if (a.empty() || b.empty()) {
    if (operation == Operation::intersect) return {};
    return a.empty() && operation == Operation::unite ? b : a;
  }
  const bool simple = a.surface_->simple && b.surface_->simple;
  if (!CGAL::do_overlap(a.surface_->box, b.surface_->box)) {
    if (operation != Operation::unite) return operation == Operation::subtract ? a : ExactSolid();
    Mesh both = a.surface_->mesh;
    CGAL::copy_face_graph(b.surface_->mesh, both);
    return ExactSolid(std::make_shared<Surface>(std::move(both), simple));
  }
  // CGAL can search for self-intersections during corefinement. That takes as long as everything
  // else, and misses contacts, at which it can crash.
  if (!simple) throw Error(ErrorKind::bad_input, "polyhedron", "its surface crosses or touches itself");
  require_little_work(a.surface_->mesh, b.surface_->mesh);
  try {
    Mesh one = a.surface_->mesh, two = b.surface_->mesh, result;
    std::array<Wanted, 4> wanted;  // in CGAL's order; one call compiles in a third of the time
    const auto place = operation == Operation::unite       ? pmp::Corefinement::UNION
                       : operation == Operation::intersect ? pmp::Corefinement::INTERSECTION
                                                           : pmp::Corefinement::TM1_MINUS_TM2;
    wanted[place] = &result;
    const bool valid = pmp::corefine_and_compute_boolean_operations(one, two, wanted)[place];
    if (!valid)
      throw Error(ErrorKind::bad_input, "polyhedron", "what comes of joining two solids is not the surface of a solid");
    if (result.number_of_faces() == 0) return {};
    // Exact constructions from simple surfaces give no self-intersections; contacts are at vertices
    // only.
    const bool touches = touches_itself(result);
    return ExactSolid(std::make_shared<Surface>(std::move(result), !touches));
  } catch (const std::logic_error&) {  // base of CGAL's own exceptions
    throw Error(ErrorKind::bad_input, "polyhedron", "its faces could not be joined");
  }
}

}  // namespace fieldfab
