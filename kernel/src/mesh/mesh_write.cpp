#include <fmt/compile.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/ply.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

static_assert(std::endian::native == std::endian::little, "binary mesh files are written as the memory holds them");

/// Calls write(i) for each item, a look at the progress between thousands.
template <class Items, class Write>
void each(const Items& items, Progress& progress, double from, const Write& write) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i % 16384 == 0) {
      progress.check();
      progress.report(from + 0.5 * static_cast<double>(i) / static_cast<double>(items.size()), "writing the mesh");
    }
    write(items[i]);
  }
}

void write_stl(const TriangleMesh& mesh, PendingFile& file, Progress& progress) {
  char header[80] = "binary STL, mm, by Fieldfab";
  file.write(header, sizeof header);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  file.write(&count, sizeof count);
  each(mesh.triangles, progress, 0.5, [&](const std::array<std::uint32_t, 3>& triangle) {
    char facet[50] = {};
    Eigen::Vector3f corner[3];
    for (std::size_t i = 0; i < 3; ++i) corner[i] = Eigen::Vector3f(mesh.vertices[triangle[i]].data());
    Eigen::Vector3d normal = (corner[1] - corner[0]).cast<double>().cross((corner[2] - corner[0]).cast<double>());
    if (normal.norm() > 0) normal.normalize();
    const Eigen::Vector3f n = normal.cast<float>();
    std::memcpy(facet, n.data(), 12);
    for (std::size_t i = 0; i < 3; ++i) std::memcpy(facet + 12 + 12 * i, corner[i].data(), 12);
    file.write(facet, sizeof facet);
  });
}

void write_ply(const TriangleMesh& mesh, PendingFile& file, const VertexProperties& properties, Progress& progress) {
  std::string described;
  for (const auto& [name, values] : properties.floats) described += fmt::format("property float {}\n", name);
  for (const auto& [name, values] : properties.integers) described += fmt::format("property int {}\n", name);
  file.write(fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment by Fieldfab, mm\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\n{}{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), properties.colours.empty() ? "" : "property uchar red\nproperty uchar green\nproperty uchar blue\n",
      described, mesh.triangles.size()));
  each(mesh.vertices, progress, 0, [&](const std::array<float, 3>& p) {
    const auto i = static_cast<std::size_t>(&p - mesh.vertices.data());
    file.write(p.data(), sizeof p);
    if (!properties.colours.empty()) file.write(properties.colours[i].data(), 3);
    for (const auto& [name, values] : properties.floats) file.write(&values[i], sizeof(float));
    for (const auto& [name, values] : properties.integers) file.write(&values[i], sizeof(int));
  });
  each(mesh.triangles, progress, 0.5, [&](const std::array<std::uint32_t, 3>& triangle) {
    char face[13] = {3};
    std::memcpy(face + 1, triangle.data(), 12);
    file.write(face, sizeof face);
  });
}

/// Text forms are read as doubles as often as floats: the digits given are those of the float as a double, so that both are
/// exact. Fewer digits would be the same float, yet another double, and triangles that nearly touch would cross each other.
void write_off(const TriangleMesh& mesh, PendingFile& file, Progress& progress) {
  file.write(fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size()));
  fmt::memory_buffer line;
  each(mesh.vertices, progress, 0, [&](const std::array<float, 3>& p) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("{} {} {}\n"), double{p[0]}, double{p[1]}, double{p[2]});
    file.write(line.data(), line.size());
  });
  each(mesh.triangles, progress, 0.5, [&](const std::array<std::uint32_t, 3>& t) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("3 {} {} {}\n"), t[0], t[1], t[2]);
    file.write(line.data(), line.size());
  });
}

void write_obj(const TriangleMesh& mesh, PendingFile& file, Progress& progress) {
  file.write("# by Fieldfab, mm\n");
  fmt::memory_buffer line;
  each(mesh.vertices, progress, 0, [&](const std::array<float, 3>& p) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("v {} {} {}\n"), double{p[0]}, double{p[1]}, double{p[2]});
    file.write(line.data(), line.size());
  });
  each(mesh.triangles, progress, 0.5, [&](const std::array<std::uint32_t, 3>& t) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("f {} {} {}\n"), t[0] + 1, t[1] + 1, t[2] + 1);
    file.write(line.data(), line.size());
  });
}

void check_size(const TriangleMesh& mesh, const std::filesystem::path& path) {
  if (mesh.triangles.size() > 0x7fffffff || mesh.vertices.size() > 0x7fffffff)
    throw Error(ErrorKind::too_large, path.string(), "mesh files hold at most 2^31 vertices and triangles");
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_mesh_extension(const std::string& extension) {
  constexpr std::array known{".stl", ".ply", ".off", ".obj", ".3mf"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, Progress& progress) {
  const std::string extension = lower_extension(path);
  if (!is_mesh_extension(extension))
    throw Error(ErrorKind::bad_input, path.string(),
                fmt::format("cannot write a mesh as '{}'; known are .stl .ply .off .obj .3mf", extension));
  check_size(mesh, path);
  PendingFile file(path);
  if (extension == ".stl") write_stl(mesh, file, progress);
  if (extension == ".ply") write_ply(mesh, file, {}, progress);
  if (extension == ".off") write_off(mesh, file, progress);
  if (extension == ".obj") write_obj(mesh, file, progress);
  if (extension == ".3mf") write_3mf(mesh, file, progress);
  file.commit();
}

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path, const VertexProperties& properties,
               Progress& progress) {
  const auto check_count = [&](const std::string& name, std::size_t count) {
    if (count != mesh.vertices.size())
      throw Error(ErrorKind::bad_input, name, fmt::format("{} values for {} vertices", count, mesh.vertices.size()));
  };
  if (!properties.colours.empty()) check_count("colours", properties.colours.size());
  for (const auto& [name, values] : properties.floats) check_count(name, values.size());
  for (const auto& [name, values] : properties.integers) check_count(name, values.size());
  check_size(mesh, path);
  PendingFile file(path);
  write_ply(mesh, file, properties, progress);
  file.commit();
}

}  // namespace fieldfab
