#include <fmt/compile.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/lower_case.h"
#include "fieldfab/core/text.h"
#include "fieldfab/mesh/ply.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

static_assert(std::endian::native == std::endian::little, "binary mesh files are written as the memory holds them");

struct Counts {
  std::uint64_t vertices = 0, triangles = 0;
};

Counts counts_of(std::span<const PartView> parts) {
  Counts all;
  for (const PartView& part : parts)
    all.vertices += part.mesh.vertices.size(), all.triangles += part.mesh.triangles.size();
  return all;
}

WritingProgress progress_of(const Counts& all, Progress& progress) { return {progress, all.vertices + all.triangles}; }

bool any_coloured(std::span<const PartView> parts) {
  return std::ranges::any_of(parts, [](const PartView& part) { return part.colour.has_value(); });
}

/// Colour of a part without one if other parts have colours and the format requires one.
constexpr Colour colourless{204, 204, 204};

void write_stl(std::span<const PartView> parts, PendingFile& file, Progress& progress) {
  char header[80] = "binary STL, mm, by Fieldfab";
  file.write(header, sizeof header);
  const auto count = static_cast<std::uint32_t>(counts_of(parts).triangles);
  file.write(&count, sizeof count);
  WritingProgress written(progress, count);
  for (const auto& [mesh, name, colour] : parts)
    for (const auto& triangle : mesh.triangles) {
      written.step();
      char facet[50] = {};
      Eigen::Vector3f corner[3];
      for (std::size_t i = 0; i < 3; ++i) corner[i] = Eigen::Vector3f(mesh.vertices[triangle[i]].data());
      Eigen::Vector3d normal = (corner[1] - corner[0]).cast<double>().cross((corner[2] - corner[0]).cast<double>());
      if (normal.norm() > 0) normal.normalize();
      const Eigen::Vector3f n = normal.cast<float>();
      std::memcpy(facet, n.data(), 12);
      for (std::size_t i = 0; i < 3; ++i) std::memcpy(facet + 12 + 12 * i, corner[i].data(), 12);
      file.write(facet, sizeof facet);
    }
}

void write_ply_header(const Counts& all, PendingFile& file, bool coloured, const std::string& described) {
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment by Fieldfab, mm\nelement vertex {}\nproperty float "
                  "x\nproperty float y\n"
                  "property float z\n{}{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                  all.vertices, coloured ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "",
                  described, all.triangles));
}

void write_colour(const Colour& colour, PendingFile& file) {
  const std::uint8_t channels[3] = {colour.red, colour.green, colour.blue};
  file.write(channels, sizeof channels);
}

/// `first` is the number of vertices before those of the mesh.
void write_ply_faces(const TriangleMesh& mesh, std::uint32_t first, PendingFile& file, WritingProgress& written) {
  for (const auto& [a, b, c] : mesh.triangles) {
    written.step();
    const std::array<std::uint32_t, 3> corners{first + a, first + b, first + c};
    char face[13] = {3};
    std::memcpy(face + 1, corners.data(), 12);
    file.write(face, sizeof face);
  }
}

void write_ply(const TriangleMesh& mesh, PendingFile& file, const VertexProperties& properties, Progress& progress) {
  std::string described;
  for (const auto& [name, values] : properties.floats) described += fmt::format("property float {}\n", name);
  for (const auto& [name, values] : properties.integers) described += fmt::format("property int {}\n", name);
  const Counts all{mesh.vertices.size(), mesh.triangles.size()};
  write_ply_header(all, file, !properties.colours.empty(), described);
  WritingProgress written = progress_of(all, progress);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    written.step();
    file.write(mesh.vertices[i].data(), sizeof mesh.vertices[i]);
    if (!properties.colours.empty()) write_colour(properties.colours[i], file);
    for (const auto& [name, values] : properties.floats) file.write(&values[i], sizeof(float));
    for (const auto& [name, values] : properties.integers) file.write(&values[i], sizeof(int));
  }
  write_ply_faces(mesh, 0, file, written);
}

void write_ply(std::span<const PartView> parts, PendingFile& file, Progress& progress) {
  const Counts all = counts_of(parts);
  const bool coloured = any_coloured(parts);
  write_ply_header(all, file, coloured, "");
  WritingProgress written = progress_of(all, progress);
  for (const PartView& part : parts) {
    const Colour colour = part.colour.value_or(colourless);
    for (const auto& p : part.mesh.vertices) {
      written.step();
      file.write(p.data(), sizeof p);
      if (coloured) write_colour(colour, file);
    }
  }
  std::uint32_t first = 0;
  for (const PartView& part : parts) {
    write_ply_faces(part.mesh, first, file, written);
    first += static_cast<std::uint32_t>(part.mesh.vertices.size());
  }
}

/// Writes a line for each vertex, and later for each triangle.
class LineWriter {
 public:
  LineWriter(const Counts& all, PendingFile& file, Progress& progress)
      : file_(file), written_(progress_of(all, progress)) {}

  /// Readers parse text as doubles or as floats. The digits are those of the float as a double, so
  /// that both are exact. Fewer digits would give the same float but another double, and triangles
  /// that nearly touch would intersect.
  void vertices(const TriangleMesh& mesh, std::string_view begins) {
    for (const auto& p : mesh.vertices)
      line([&](auto out) {
        fmt::format_to(out, FMT_COMPILE("{}{} {} {}\n"), begins, double{p[0]}, double{p[1]}, double{p[2]});
      });
  }
  /// `first` is the number of the mesh's first vertex.
  void triangles(const TriangleMesh& mesh, std::string_view begins, std::uint32_t first) {
    for (const auto& [a, b, c] : mesh.triangles)
      line(
          [&](auto out) { fmt::format_to(out, FMT_COMPILE("{}{} {} {}\n"), begins, first + a, first + b, first + c); });
  }

 private:
  template <class Format>
  void line(const Format& format) {
    written_.step();
    line_.clear();
    format(std::back_inserter(line_));
    file_.write(line_.data(), line_.size());
  }

  PendingFile& file_;
  WritingProgress written_;
  fmt::memory_buffer line_;
};

void write_off(std::span<const PartView> parts, PendingFile& file, Progress& progress) {
  const Counts all = counts_of(parts);
  file.write(fmt::format("OFF\n{} {} 0\n", all.vertices, all.triangles));
  LineWriter lines(all, file, progress);
  for (const PartView& part : parts) lines.vertices(part.mesh, "");
  std::uint32_t first = 0;
  for (const PartView& part : parts) {
    lines.triangles(part.mesh, "3 ", first);
    first += static_cast<std::uint32_t>(part.mesh.vertices.size());
  }
}

/// Returns a name as one word for readers of .obj files: without white space, comment or line
/// continuation.
std::string obj_word(std::string_view name) {
  std::string word = printable(name);
  for (char& c : word)
    if (c == ' ' || c == '#' || c == '\\') c = '_';
  return word;
}

std::string material_name(const std::optional<Colour>& colour) {
  return colour ? "colour_" + text_of(*colour).substr(1) : "colourless";
}

/// Writes the materials of .obj files, one per colour. Channels are sRGB / 255, as most readers
/// expect.
void write_mtl(std::span<const PartView> parts, PendingFile& file) {
  file.write("# by Fieldfab\n");
  std::unordered_set<std::string> known;
  for (const PartView& part : parts) {
    const std::string name = material_name(part.colour);
    if (!known.insert(name).second) continue;
    const Colour colour = part.colour.value_or(colourless);
    file.write(fmt::format("newmtl {}\nKd {:.6g} {:.6g} {:.6g}\n", name, colour.red / 255.0, colour.green / 255.0,
                           colour.blue / 255.0));
  }
}

/// `materials` is the name of the .mtl file, or empty.
void write_obj(std::span<const PartView> parts, PendingFile& file, const std::string& materials, Progress& progress) {
  file.write("# by Fieldfab, mm\n");
  if (!materials.empty()) file.write(fmt::format("mtllib {}\n", materials));
  LineWriter lines(counts_of(parts), file, progress);
  PartNames names('_');
  std::uint32_t first = 1;
  for (const PartView& part : parts) {
    if (parts.size() > 1 || !part.name.empty())
      file.write(fmt::format("o {}\n", names.unique(part.name.empty() ? "part" : obj_word(part.name))));
    if (!materials.empty()) file.write(fmt::format("usemtl {}\n", material_name(part.colour)));
    lines.vertices(part.mesh, "v ");
    lines.triangles(part.mesh, "f ", first);
    first += static_cast<std::uint32_t>(part.mesh.vertices.size());
  }
}

/// Writes an .obj file and its materials.
void write_obj_with_materials(std::span<const PartView> parts, const std::filesystem::path& path, Progress& progress) {
  // A name with control characters would end its line.
  const std::string name = printable(path.stem().string() + ".mtl");
  PendingFile materials(path.parent_path() / name), file(path);
  write_mtl(parts, materials);
  write_obj(parts, file, name, progress);
  commit_both(materials, file);
}

void check_size(const Counts& all, const std::filesystem::path& path) {
  if (all.triangles > 0x7fffffff || all.vertices > 0x7fffffff)
    throw Error(ErrorKind::too_large, path.string(), "mesh files hold at most 2^31 vertices and triangles");
}

void write_parts(std::span<const PartView> parts, const std::filesystem::path& path, Progress& progress) {
  const std::string extension = lower_extension(path);
  if (!is_mesh_extension(extension))
    throw Error(ErrorKind::bad_input, path.string(),
                fmt::format("cannot write a mesh as '{}'; known are .stl .ply .off .obj .3mf .glb", extension));
  check_size(counts_of(parts), path);
  if (extension == ".obj" && any_coloured(parts)) return write_obj_with_materials(parts, path, progress);
  PendingFile file(path);
  if (extension == ".stl") write_stl(parts, file, progress);
  if (extension == ".ply") write_ply(parts, file, progress);
  if (extension == ".off") write_off(parts, file, progress);
  if (extension == ".obj") write_obj(parts, file, "", progress);
  if (extension == ".3mf") write_3mf(parts, file, progress);
  if (extension == ".glb") write_glb(parts, file, path, progress);
  file.commit();
}

}  // namespace

bool is_mesh_extension(const std::string& extension) {
  constexpr std::array known{".stl", ".ply", ".off", ".obj", ".3mf", ".glb"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

std::string PartNames::unique(std::string name) {
  if (given_.insert(name).second) return name;
  std::uint32_t& last = last_.try_emplace(name, 1).first->second;
  std::string numbered;
  do numbered = fmt::format("{}{}{}", name, separator_, ++last);
  while (!given_.insert(numbered).second);
  return numbered;
}

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, Progress& progress) {
  const PartView part{mesh};
  write_parts({&part, 1}, path, progress);
}

void write_mesh_parts(std::span<const MeshPart> parts, const std::filesystem::path& path, Progress& progress) {
  if (parts.empty()) throw Error(ErrorKind::bad_input, path.string(), "there is no part to write");
  std::vector<PartView> views;
  for (const MeshPart& part : parts) views.push_back({part.mesh, part.name, part.colour});
  write_parts(views, path, progress);
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
  check_size({mesh.vertices.size(), mesh.triangles.size()}, path);
  PendingFile file(path);
  write_ply(mesh, file, properties, progress);
  file.commit();
}

}  // namespace fieldfab
