// Mesh files through OpenMesh; a .3mf through lib3mf.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cmath>
#include <unordered_map>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

struct HashPosition {
  std::size_t operator()(const std::array<float, 3>& p) const {
    std::size_t seed = 0;
    for (const float c : p) seed = (seed ^ std::hash<float>{}(c)) * 0x9e3779b97f4a7c15ULL;
    return seed ^ (seed >> 32);
  }
};

/// Equal vertices become one; triangles that come to nothing by that are left out.
TriangleMesh merged(const TriangleMesh& soup, const std::filesystem::path& path) {
  TriangleMesh mesh;
  std::unordered_map<std::array<float, 3>, std::uint32_t, HashPosition> place;
  std::vector<std::uint32_t> renamed;
  renamed.reserve(soup.vertices.size());
  for (std::array<float, 3> p : soup.vertices) {
    for (float& c : p) {
      if (!std::isfinite(c)) throw Error(ErrorKind::bad_input, path.string(), "a vertex is not a finite number");
      if (c == 0) c = 0;  // one zero
    }
    const auto [at, is_new] = place.try_emplace(p, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(p);
    renamed.push_back(at->second);
  }
  for (std::array<std::uint32_t, 3> t : soup.triangles) {
    for (std::uint32_t& vertex : t) {
      if (vertex >= renamed.size()) throw Error(ErrorKind::bad_input, path.string(), "a triangle refers to a vertex that is not there");
      vertex = renamed[vertex];
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  if (mesh.triangles.empty()) throw Error(ErrorKind::bad_input, path.string(), "holds no triangles");
  return mesh;
}

TriangleMesh read_with_openmesh(const std::filesystem::path& path) {
  omerr().disable();  // what OpenMesh would print is said by the exception
  omlog().disable();
  OpenMesh::PolyMesh_ArrayKernelT<> open;
  OpenMesh::IO::Options options;
  bool read = false;
  try {
    read = OpenMesh::IO::read_mesh(open, path.string(), options);
  } catch (const std::exception&) {
    read = false;
  }
  if (!read) throw Error(ErrorKind::bad_input, path.string(), "is not a mesh that can be read as its extension says");
  TriangleMesh soup;
  for (const auto vertex : open.vertices()) {
    const auto& p = open.point(vertex);
    soup.vertices.push_back({p[0], p[1], p[2]});
  }
  std::vector<std::uint32_t> corners;
  for (const auto face : open.faces()) {
    corners.clear();
    for (const auto vertex : face.vertices()) corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) soup.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return soup;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (!is_mesh_extension(extension))
    throw Error(ErrorKind::bad_input, path.string(), "is not a mesh file; known are .stl .ply .off .obj .3mf");
  read_file(path);  // a file that is not there or not readable says so itself
  return merged(extension == ".3mf" ? read_3mf(path) : read_with_openmesh(path), path);
}

}  // namespace fieldfab
