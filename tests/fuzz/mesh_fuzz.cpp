// Any bytes as a mesh file of the format selected by the first byte: an Error, or triangles with
// valid indices that survive a round trip through our writer. three_mf_fuzz.cpp tests .3mf.
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/triangle_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_mesh_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  constexpr const char* names[] = {"s.stl", "p.ply", "f.off", "o.obj"};
  if (size == 0) return 0;
  const auto path = folder / names[data[0] % 4];
  write_file(path, {reinterpret_cast<const char*>(data) + 1, size - 1});
  try {
    const TriangleMesh mesh = read_mesh(path);
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle)
        if (vertex >= mesh.vertices.size() || !std::isfinite(mesh.vertices[vertex][0])) std::abort();
    write_mesh(mesh, folder / "again.ply");
    if (read_mesh(folder / "again.ply").triangles.size() > mesh.triangles.size()) std::abort();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
