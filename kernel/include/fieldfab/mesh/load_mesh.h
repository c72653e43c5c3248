/// Mesh files read, with what they hold beside the mesh.
#pragma once

#include <string>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// A mesh from a file.
struct MeshFromFile {
  TriangleMesh mesh;
  std::vector<std::string> notes = {};  ///< what of the file was left out, for people, one line each
};

/// As read_mesh(), with notes. Of a .3mf file all that its build places is one mesh, in mm: components and transforms are
/// carried out. Throws io, bad_input, cancelled, and too_large for a file that would make more than 2^31 triangles or more than
/// memory holds.
MeshFromFile load_mesh(const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab
