/// The 3MF side of mesh files, which needs a library of its own.
#pragma once

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

void write_3mf(const TriangleMesh& mesh, const std::filesystem::path& path);
/// Triangles as they are in the file, all objects of its build together.
TriangleMesh read_3mf(const std::filesystem::path& path);

/// The extension in lower case, with the dot.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace fieldfab
