/// The 3MF side of mesh files, and what readers and writers share.
#pragma once

#include "fieldfab/core/file.h"
#include "fieldfab/mesh/load_mesh.h"

namespace fieldfab {

void write_3mf(const TriangleMesh& mesh, PendingFile& file, Progress& progress);
/// Triangles as they are in the file, all that its build places together, in mm. `bytes` are the file's.
MeshFromFile read_3mf(std::string_view bytes, const std::filesystem::path& path, Progress& progress);

/// The extension in lower case, with the dot.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace fieldfab
