#include "exact_solid.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "fieldfab/core/error.h"

namespace fieldfab::openscad {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

using QuickKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using QuickMesh = CGAL::Surface_mesh<QuickKernel::Point_3>;

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
    Triangle t{};
    std::size_t i = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) t[i++ % 3] = number[vertex.idx()];
    solid.triangles.push_back(t);
  }
  return solid;
}

/// False where an edge has more than two faces.
bool to_quick(const Polyhedron& surface, QuickMesh& mesh) {
  std::vector<QuickKernel::Point_3> points;
  for (const Vec3& p : surface.vertices) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> faces;
  for (const Triangle& t : surface.triangles) faces.push_back({t[0], t[1], t[2]});
  if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) return false;
  pmp::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return true;
}

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

/// How far a triangle's corner is from its longest edge, which begins at the first corner.
double height(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / (b - a).norm(); }

/// Where a corner of a triangle all but lies on the edge opposite: the triangle beyond that edge is divided there instead, if
/// both halves look where it does and neither is as narrow.
bool turn_longest_edge(QuickMesh& mesh, QuickMesh::Face_index face, double narrowest) {
  auto longest = mesh.halfedge(face);
  const auto length = [&](QuickMesh::Halfedge_index half) {
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

}  // namespace

struct ExactSolid::Surface {
  Mesh mesh;
  CGAL::Bbox_3 box;

  explicit Surface(Mesh whole) : mesh(std::move(whole)) {
    for (const auto vertex : mesh.vertices()) box += mesh.point(vertex).bbox();
  }
};

ExactSolid::ExactSolid(const Polyhedron& solid) {
  if (solid.empty()) return;
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
  surface_ = std::make_shared<Surface>(std::move(mesh));
}

Polyhedron ExactSolid::polyhedron() const { return empty() ? Polyhedron() : corners_of(surface_->mesh); }

ExactSolid combined(const ExactSolid& a, const ExactSolid& b, Operation operation) {
  using Surface = ExactSolid::Surface;
  if (a.empty() || b.empty()) {
    if (operation == Operation::intersect) return {};
    return a.empty() && operation == Operation::unite ? b : a;
  }
  if (!CGAL::do_overlap(a.surface_->box, b.surface_->box)) {
    if (operation != Operation::unite) return operation == Operation::subtract ? a : ExactSolid();
    Mesh both = a.surface_->mesh;
    CGAL::copy_face_graph(b.surface_->mesh, both);
    return ExactSolid(std::make_shared<Surface>(std::move(both)));
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
    const auto throwing = pmp::parameters::throw_on_self_intersection(true);
    const bool valid = pmp::corefine_and_compute_boolean_operations(one, two, wanted, throwing)[place];
    if (!valid) throw Error(ErrorKind::bad_input, "polyhedron", "what comes of joining two solids is not the surface of a solid");
    return result.number_of_faces() == 0 ? ExactSolid() : ExactSolid(std::make_shared<Surface>(std::move(result)));
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    throw Error(ErrorKind::bad_input, "polyhedron", "its surface crosses itself");
  } catch (const std::logic_error&) {  // CGAL's own failures are such
    throw Error(ErrorKind::bad_input, "polyhedron", "its faces could not be joined");
  }
}

ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress) {
  if (solids.empty()) return {};
  while (solids.size() > 1) {
    std::vector<ExactSolid> half;
    for (std::size_t i = 0; i + 1 < solids.size(); i += 2) {
      progress.report(0, "joining solids");
      progress.check();
      half.push_back(combined(solids[i], solids[i + 1], operation));
    }
    if (solids.size() % 2 == 1) half.push_back(std::move(solids.back()));
    solids = std::move(half);
  }
  return std::move(solids.front());
}

Polyhedron without_slivers(const Polyhedron& surface, double narrowest) {
  QuickMesh mesh;
  if (!to_quick(surface, mesh)) return surface;
  const std::vector<QuickMesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
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

bool bounds_a_solid(const Polyhedron& surface) {
  QuickMesh mesh;
  return to_quick(surface, mesh) && CGAL::is_closed(mesh) && !pmp::does_self_intersect(mesh) && pmp::is_outward_oriented(mesh) &&
         pmp::does_bound_a_volume(mesh);
}

}  // namespace fieldfab::openscad
