#include "fieldfab/mesh/openmesh.h"

#include "fieldfab/core/error.h"

namespace fieldfab {

OpenTriangleMesh to_openmesh(const TriangleMesh& mesh) {
  OpenTriangleMesh open;
  open.reserve(mesh.vertices.size(), mesh.triangles.size() * 3 / 2, mesh.triangles.size());
  for (const auto& p : mesh.vertices) open.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : mesh.triangles) {
    const auto vertex = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(t[i])); };
    if (!open.add_face(vertex(0), vertex(1), vertex(2)).is_valid())
      throw Error(ErrorKind::bad_input, "mesh",
                  "an edge belongs to more than two triangles, or to two of opposite orientation");
  }
  return open;
}

TriangleMesh from_openmesh(const OpenTriangleMesh& open) {
  TriangleMesh mesh;
  mesh.vertices.reserve(open.n_vertices());
  for (const auto vertex : open.all_vertices()) {
    const auto& p = open.point(vertex);
    mesh.vertices.push_back({p[0], p[1], p[2]});
  }
  for (const auto face : open.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t i = 0;
    for (const auto vertex : face.vertices()) triangle[i++] = static_cast<std::uint32_t>(vertex.idx());
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace fieldfab
