// What two exact solids make, by CGAL's corefinement.
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>

#include "exact_surface.h"
#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;

/// A face as far as it matters for what it meets.
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

/// Each pair of faces that cross costs exact constructions, and one in the same plane many.
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

/// Whether two corners of a surface are, or may be, at the same place: that is how what corefinement makes touches itself.
bool has_double_corners(const Mesh& mesh, const CGAL::Bbox_3& box) {
  const Vec3 way(0.61803, 0.54931, 0.56226);  // along which different corners are at different places as a rule
  std::vector<std::pair<double, Vec3>> corners;
  corners.reserve(mesh.number_of_vertices());
  for (const auto vertex : mesh.vertices()) {
    const Vec3 place = rounded(mesh.point(vertex));
    corners.emplace_back(way.dot(place), place);
  }
  std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const double same = 1e-12 * std::max({-box.xmin(), -box.ymin(), -box.zmin(), box.xmax(), box.ymax(), box.zmax()});
  for (auto a = corners.begin(); a != corners.end(); ++a)
    for (auto b = a + 1; b != corners.end() && b->first - a->first <= 2 * same; ++b)
      if ((b->second - a->second).norm() <= same) return true;
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
  require_little_work(a.surface_->mesh, b.surface_->mesh);
  try {
    Mesh one = a.surface_->mesh, two = b.surface_->mesh, result;
    std::array<boost::optional<Mesh*>, 4>
        wanted;  // in CGAL's order; asked for by one call, which compiles in a third of the time
    const auto place = operation == Operation::unite       ? pmp::Corefinement::UNION
                       : operation == Operation::intersect ? pmp::Corefinement::INTERSECTION
                                                           : pmp::Corefinement::TM1_MINUS_TM2;
    wanted[place] = &result;
    // What exact constructions make of simple surfaces is simple; to look for crossings takes as long as all else.
    const auto throwing = pmp::parameters::throw_on_self_intersection(!simple);
    const bool valid = pmp::corefine_and_compute_boolean_operations(one, two, wanted, throwing)[place];
    if (!valid) throw Error(ErrorKind::bad_input, "polyhedron", "what comes of joining two solids is not the surface of a solid");
    if (result.number_of_faces() == 0) return {};
    auto surface = std::make_shared<Surface>(std::move(result), simple);
    surface->simple = simple && !has_double_corners(surface->mesh, surface->box);
    return ExactSolid(std::move(surface));
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    throw Error(ErrorKind::bad_input, "polyhedron", "its surface crosses itself");
  } catch (const std::logic_error&) {  // CGAL's own failures are such
    throw Error(ErrorKind::bad_input, "polyhedron", "its faces could not be joined");
  }
}

}  // namespace fieldfab
