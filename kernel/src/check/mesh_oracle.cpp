#include "mesh_oracle.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR < 6
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_traits_3.h>
#endif

#include <cmath>
#include <optional>

namespace fieldfab {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
#if CGAL_VERSION_MAJOR < 6
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif
}  // namespace

struct MeshOracle::Cgal {
  Surface surface;
  Tree tree;
  std::optional<CGAL::Side_of_triangle_mesh<Surface, Kernel>> side;
};

MeshOracle::MeshOracle(const TriangleMesh& mesh) : cgal_(std::make_unique<Cgal>()) {
  for (const auto& p : mesh.vertices) cgal_->surface.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& t : mesh.triangles)
    cgal_->surface.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]), Surface::Vertex_index(t[2]));
  cgal_->tree.insert(faces(cgal_->surface).first, faces(cgal_->surface).second, cgal_->surface);
  cgal_->tree.build();
  cgal_->tree.accelerate_distance_queries();
  cgal_->side.emplace(cgal_->tree);
}

MeshOracle::~MeshOracle() = default;

bool MeshOracle::inside(const Vec3& p) const {
  return (*cgal_->side)(Kernel::Point_3(p.x(), p.y(), p.z())) == CGAL::ON_BOUNDED_SIDE;
}

double MeshOracle::distance(const Vec3& p) const {
  return std::sqrt(cgal_->tree.squared_distance(Kernel::Point_3(p.x(), p.y(), p.z())));
}

}  // namespace fieldfab
