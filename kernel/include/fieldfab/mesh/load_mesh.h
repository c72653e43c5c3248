/// Reading of mesh files, with notes on omitted content.
#pragma once

#include <string>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// A mesh read from a file.
struct MeshFromFile {
  TriangleMesh mesh;
  std::vector<std::string> notes = {};  ///< omitted content, for people, one line each
};

/// Reads a mesh file as read_mesh() does, with notes. All items of a .3mf file's build become one mesh in mm, with
/// components and transforms applied. Throws Error(io), Error(bad_input), Error(cancelled), Error(too_large) for more
/// than 2^31 triangles or more than the memory holds.
MeshFromFile load_mesh(const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab
