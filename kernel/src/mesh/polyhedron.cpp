#include "fieldfab/mesh/polyhedron.h"

#include <map>

namespace fieldfab {

Box Polyhedron::bounds() const {
  Box box{vertices.front(), vertices.front()};
  for (const Vec3& p : vertices) box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
  return box;
}

void Polyhedron::add(const Polyhedron& other) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Polyhedron::Triangle& t : other.triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Polyhedron moved(const Polyhedron& solid, const Eigen::Affine3d& placement) {
  Polyhedron result = solid;
  for (Vec3& p : result.vertices) p = placement * p;
  if (placement.linear().determinant() < 0)
    for (Polyhedron::Triangle& t : result.triangles) std::swap(t[1], t[2]);
  return result;
}

Polyhedron welded(const Polyhedron& solid) {
  Polyhedron result;
  std::map<std::array<double, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> number;
  number.reserve(solid.vertices.size());
  for (const Vec3& p : solid.vertices) {
    const auto [found, is_new] =
        known.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, static_cast<std::uint32_t>(result.vertices.size()));
    if (is_new) result.vertices.push_back(p);
    number.push_back(found->second);
  }
  for (const Polyhedron::Triangle& t : solid.triangles) {
    const Polyhedron::Triangle here{number[t[0]], number[t[1]], number[t[2]]};
    if (here[0] != here[1] && here[1] != here[2] && here[2] != here[0]) result.triangles.push_back(here);
  }
  return result;
}

TriangleMesh to_mesh(const Polyhedron& solid) {
  TriangleMesh mesh;
  for (const Vec3& p : solid.vertices)
    mesh.vertices.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  mesh.triangles.assign(solid.triangles.begin(), solid.triangles.end());
  return mesh;
}

Polyhedron to_polyhedron(const TriangleMesh& mesh) {
  Polyhedron solid;
  for (const auto& p : mesh.vertices) solid.vertices.emplace_back(p[0], p[1], p[2]);
  solid.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  return solid;
}

}  // namespace fieldfab
