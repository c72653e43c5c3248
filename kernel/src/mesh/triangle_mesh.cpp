#include "fieldfab/mesh/triangle_mesh.h"

#include <Eigen/Geometry>

namespace fieldfab {
namespace {

Vec3 corner(const TriangleMesh& mesh, std::uint32_t vertex) {
  const auto& p = mesh.vertices[vertex];
  return {p[0], p[1], p[2]};
}

}  // namespace

double TriangleMesh::volume() const {
  if (vertices.empty()) return 0;
  const Vec3 origin = corner(*this, 0);  // near the mesh, so that large coordinates cancel early
  double six_volumes = 0;
  for (const auto& t : triangles)
    six_volumes += (corner(*this, t[0]) - origin).cross(corner(*this, t[1]) - origin).dot(corner(*this, t[2]) - origin);
  return six_volumes / 6;
}

double TriangleMesh::area() const {
  double doubled = 0;
  for (const auto& t : triangles) {
    const Vec3 a = corner(*this, t[0]);
    doubled += (corner(*this, t[1]) - a).cross(corner(*this, t[2]) - a).norm();
  }
  return doubled / 2;
}

Box TriangleMesh::bounds() const {
  if (vertices.empty()) return {};
  Box box{corner(*this, 0), corner(*this, 0)};
  for (std::uint32_t i = 1; i < vertices.size(); ++i) box = hull(box, {corner(*this, i), corner(*this, i)});
  return box;
}

}  // namespace fieldfab
