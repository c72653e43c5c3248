// Any bytes as a .3mf archive, or as the model part of one, selected by the first byte: an Error,
// or triangles with valid indices that survive a round trip through our writer, as one mesh and as
// parts.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "mesh/zip_archive.h"

namespace {

constexpr std::string_view relationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" )"
    R"(Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    "</Relationships>";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_three_mf_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto path = folder / "a.3mf";
  PendingFile file(path);
  if (data[0] == 'P') {  // an archive starts with it, too
    file.write(data, size);
  } else {
    ZipWriter zip(file);
    zip.add_part("_rels/.rels", relationships);
    zip.add_part("3D/3dmodel.model", bytes);
    zip.add_part("3D/other.model", bytes);
    zip.finish();
  }
  file.commit();
  try {
    const MeshFromFile read = load_mesh(path);
    std::vector<std::string> notes;
    const std::vector<MeshPart> parts = load_mesh_parts(path, Progress::none(), notes);
    for (const auto& triangle : read.mesh.triangles)
      for (const std::uint32_t vertex : triangle)
        if (vertex >= read.mesh.vertices.size() || !std::isfinite(read.mesh.vertices[vertex][0])) std::abort();
    if (read.mesh.triangles.size() > 10'000) return 0;
    write_mesh(read.mesh, path);
    const MeshFromFile again = load_mesh(path);
    if (again.mesh.triangles != read.mesh.triangles || again.mesh.vertices != read.mesh.vertices ||
        !again.notes.empty())
      std::abort();
    write_mesh_parts(parts, path);
    notes.clear();
    const std::vector<MeshPart> parts_again = load_mesh_parts(path, Progress::none(), notes);
    const auto same = [](const MeshPart& a, const MeshPart& b) {
      return a.name == b.name && a.colour == b.colour && a.mesh.triangles == b.mesh.triangles &&
             a.mesh.vertices == b.mesh.vertices;
    };
    if (!std::ranges::equal(parts, parts_again, same) || !notes.empty()) std::abort();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
