// Readers of STL, PLY, OFF and OBJ. Our own, since OpenMesh's PLY reader never returns if a header
// is truncated.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <unordered_map>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/lower_case.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

using Position = std::array<float, 3>;

constexpr std::size_t often = 16384;  // items between two checks for cancellation

struct HashPosition {
  std::size_t operator()(const Position& p) const {
    std::size_t seed = 0;
    for (const float c : p) seed = (seed ^ std::hash<float>{}(c)) * 0x9e3779b97f4a7c15ULL;
    return seed ^ (seed >> 32);
  }
};

/// Bytes of a mesh file, and the triangles found in them so far.
class MeshReader {
 public:
  MeshReader(std::string bytes, const std::filesystem::path& path, Progress& progress)
      : bytes_(std::move(bytes)), path_(path), progress_(progress) {}

  TriangleMesh stl() {
    std::uint32_t count = 0;
    if (bytes_.size() >= 84) std::memcpy(&count, bytes_.data() + 80, 4);
    if (bytes_.size() >= 84 && bytes_.size() == 84 + std::size_t{50} * count) return binary_stl(count);
    if (!bytes_.starts_with("solid")) fail("is not an STL file: its size does not fit its count of triangles");
    std::vector<std::uint32_t> corners;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (word == "vertex") corners.push_back(add_vertex());
      if (word != "endloop") continue;
      add_polygon(corners);
      corners.clear();
    }
    return std::move(soup_);
  }

  TriangleMesh off() {
    if (const std::string_view magic = next(); magic != "OFF" && magic != "COFF" && magic != "NOFF")
      fail("does not begin with OFF");
    const std::size_t vertices = count(), faces = count();
    count();  // number of edges, unused
    for (std::size_t i = 0; i < vertices; ++i) {
      add_vertex();
      skip_line();  // colours or normals
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < faces; ++i) {
      corners.resize(checked_size(count()));
      for (std::uint32_t& corner : corners) corner = index(static_cast<double>(count()));
      add_polygon(corners);
      skip_line();
    }
    return std::move(soup_);
  }

  TriangleMesh obj() {
    std::vector<std::uint32_t> corners;
    while (at_ < bytes_.size()) {
      const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
      const std::string_view kind = next_before(end);
      if (kind == "v") add_vertex();
      if (kind == "f") {
        corners.clear();
        for (std::string_view word = next_before(end); !word.empty(); word = next_before(end)) {
          const auto index = parse<long>(word.substr(0, word.find('/')));
          const long place = index < 0 ? static_cast<long>(soup_.vertices.size()) + index : index - 1;
          corners.push_back(this->index(static_cast<double>(place)));
        }
        add_polygon(corners);
      }
      at_ = end + 1;
    }
    return std::move(soup_);
  }

  TriangleMesh ply() {
    if (next() != "ply") fail("does not begin with ply");
    std::vector<Element> elements;
    std::string format;
    for (std::string_view word = next(); word != "end_header"; word = next()) {
      if (word.empty()) fail("its header has no end");
      if (word == "format") format = next();
      if (word == "element") {
        const std::string name(next());
        elements.push_back({name, checked_size(count()), {}});
      }
      if (word == "property" && !elements.empty()) {
        std::string type(next()), length;
        if (type == "list") length = next(), type = next();
        elements.back().properties.push_back(
            {std::string(next()), type_of(type), length.empty() ? Type::none : type_of(length)});
      }
      if (word == "comment" || word == "obj_info") skip_line();
    }
    skip_line();
    if (format != "ascii" && format != "binary_little_endian")
      fail(fmt::format("is PLY of the form '{:.30}', which is not read", format));
    const bool binary = format != "ascii";
    for (const Element& element : elements)
      for (std::size_t i = 0; i < element.count; ++i) read_element(element, binary);
    return std::move(soup_);
  }

 private:
  enum class Type : std::uint8_t { none, i1, u1, i2, u2, i4, u4, f4, f8 };
  struct Property {
    std::string name;
    Type type, length;
  };
  struct Element {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;
  };

  [[noreturn]] void fail(const std::string& how) const { throw Error(ErrorKind::bad_input, path_.string(), how); }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  /// Returns the next word before byte `end`, or an empty one. A '#' begins a comment.
  std::string_view next_before(std::size_t end) {
    while (at_ < end && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#')
        at_ = std::min(bytes_.find('\n', at_), end);
      else
        ++at_;
    }
    const std::size_t start = at_;
    while (at_ < end && !is_space(bytes_[at_])) ++at_;
    return std::string_view(bytes_).substr(start, at_ - start);
  }
  std::string_view next() { return next_before(bytes_.size()); }
  void skip_line() { at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1) + 1; }

  template <class Number>
  Number parse(std::string_view word) const {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc{} || result.ptr != word.data() + word.size())
      fail(fmt::format("expected a number, found '{:.30}'", word));
    return value;
  }
  std::size_t count() { return parse<std::size_t>(next()); }
  std::size_t checked_size(std::size_t size) const {
    if (size > bytes_.size()) fail("a count is larger than the file");
    return size;
  }

  std::uint32_t add_vertex() {
    if (soup_.vertices.size() % often == 0) progress_.check();
    Position p;
    for (float& c : p) c = static_cast<float>(parse<double>(next()));
    soup_.vertices.push_back(p);
    return static_cast<std::uint32_t>(soup_.vertices.size() - 1);
  }
  void add_polygon(const std::vector<std::uint32_t>& corners) {
    if (soup_.triangles.size() % often == 0) progress_.check();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      soup_.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }

  TriangleMesh binary_stl(std::uint32_t triangles) {
    for (std::size_t i = 0; i < triangles; ++i) {
      const auto first = static_cast<std::uint32_t>(soup_.vertices.size());
      for (std::size_t corner = 0; corner < 3; ++corner) {
        Position p;
        std::memcpy(p.data(), bytes_.data() + 84 + 50 * i + 12 + 12 * corner, 12);
        soup_.vertices.push_back(p);
      }
      soup_.triangles.push_back({first, first + 1, first + 2});
    }
    return std::move(soup_);
  }

  Type type_of(std::string_view name) const {
    if (name == "char" || name == "int8") return Type::i1;
    if (name == "uchar" || name == "uint8") return Type::u1;
    if (name == "short" || name == "int16") return Type::i2;
    if (name == "ushort" || name == "uint16") return Type::u2;
    if (name == "int" || name == "int32") return Type::i4;
    if (name == "uint" || name == "uint32") return Type::u4;
    if (name == "float" || name == "float32") return Type::f4;
    if (name == "double" || name == "float64") return Type::f8;
    fail(fmt::format("has a property of unknown type '{:.30}'", name));
  }
  template <class Number>
  double binary() {
    Number value;
    if (bytes_.size() - at_ < sizeof value) fail("ends too early");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return static_cast<double>(value);
  }
  double value(Type type, bool is_binary) {
    if (!is_binary) return parse<double>(next());
    switch (type) {
      case Type::i1: return binary<std::int8_t>();
      case Type::u1: return binary<std::uint8_t>();
      case Type::i2: return binary<std::int16_t>();
      case Type::u2: return binary<std::uint16_t>();
      case Type::i4: return binary<std::int32_t>();
      case Type::u4: return binary<std::uint32_t>();
      case Type::f4: return binary<float>();
      default: return binary<double>();
    }
  }
  std::uint32_t index(double number) const {
    if (!(number >= 0 && number < 4294967295.0)) fail("a face refers to a vertex that is not there");
    return static_cast<std::uint32_t>(number);
  }
  void read_element(const Element& element, bool is_binary) {
    if (at_ >= bytes_.size()) fail("ends too early");
    Position p{};
    for (const Property& property : element.properties) {
      if (property.length == Type::none) {
        const double number = value(property.type, is_binary);
        const std::size_t axis = std::string_view("xyz").find(property.name);
        if (property.name.size() == 1 && axis < 3) p[axis] = static_cast<float>(number);
        continue;
      }
      const double length = value(property.length, is_binary);
      if (!(length >= 0)) fail("a list has a negative length");
      std::vector<std::uint32_t> corners;
      const bool face =
          element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
      for (std::size_t i = 0, size = checked_size(static_cast<std::size_t>(std::min(length, 1e18))); i < size; ++i) {
        const double number = value(property.type, is_binary);
        if (face) corners.push_back(index(number));
      }
      add_polygon(corners);
    }
    if (element.name == "vertex") soup_.vertices.push_back(p);
  }

  std::string bytes_;
  const std::filesystem::path& path_;
  Progress& progress_;
  std::size_t at_ = 0;
  TriangleMesh soup_;
};

/// Merges equal vertices and removes triangles that become degenerate, which may be all.
TriangleMesh merged_or_empty(const TriangleMesh& soup, const std::filesystem::path& path, Progress& progress) {
  TriangleMesh mesh;
  std::unordered_map<Position, std::uint32_t, HashPosition> place;
  std::vector<std::uint32_t> renamed;
  renamed.reserve(soup.vertices.size());
  for (Position p : soup.vertices) {
    if (renamed.size() % often == 0) progress.check();
    for (float& c : p) {
      if (!std::isfinite(c)) throw Error(ErrorKind::bad_input, path.string(), "a vertex is not a finite number");
      if (c == 0) c = 0;  // one zero
    }
    const auto [at, is_new] = place.try_emplace(p, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(p);
    renamed.push_back(at->second);
  }
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (i % often == 0) progress.check();
    std::array<std::uint32_t, 3> t = soup.triangles[i];
    for (std::uint32_t& vertex : t) {
      if (vertex >= renamed.size())
        throw Error(ErrorKind::bad_input, path.string(), "a face refers to a vertex that is not there");
      vertex = renamed[vertex];
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  return mesh;
}

[[noreturn]] void fail_empty(const std::filesystem::path& path) {
  throw Error(ErrorKind::bad_input, path.string(), "holds no triangles");
}

TriangleMesh merged(const TriangleMesh& soup, const std::filesystem::path& path, Progress& progress) {
  TriangleMesh mesh = merged_or_empty(soup, path, progress);
  if (mesh.triangles.empty()) fail_empty(path);
  return mesh;
}

/// Reads the bytes of a mesh file of a readable format, given by `extension`.
std::string read_mesh_file(const std::filesystem::path& path, const std::string& extension) {
  if (extension == ".glb")
    throw Error(ErrorKind::bad_input, path.string(),
                "is written, not read; meshes are read from .stl .ply .off .obj .3mf");
  if (!is_mesh_extension(extension))
    throw Error(ErrorKind::bad_input, path.string(), "is not a mesh file; known are .stl .ply .off .obj .3mf");
  return read_file(path, std::uintmax_t{1} << 36);
}

}  // namespace

MeshFromFile load_mesh(const std::filesystem::path& path, Progress& progress) {
  const std::string extension = lower_extension(path);
  std::string bytes = read_mesh_file(path, extension);
  MeshFromFile result;
  if (extension == ".3mf") {
    result = read_3mf(bytes, path, progress);
  } else {
    MeshReader reader(std::move(bytes), path, progress);
    result.mesh = extension == ".stl"   ? reader.stl()
                  : extension == ".ply" ? reader.ply()
                  : extension == ".off" ? reader.off()
                                        : reader.obj();
  }
  result.mesh = merged(result.mesh, path, progress);
  return result;
}

std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& path, Progress& progress,
                                      std::vector<std::string>& notes) {
  if (lower_extension(path) != ".3mf") {
    MeshFromFile file = load_mesh(path, progress);
    std::ranges::move(file.notes, std::back_inserter(notes));
    std::vector<MeshPart> parts(1);
    parts[0].mesh = std::move(file.mesh);
    return parts;
  }
  std::vector<MeshPart> parts = read_3mf_parts(read_mesh_file(path, ".3mf"), path, progress, notes);
  for (MeshPart& part : parts) part.mesh = merged_or_empty(part.mesh, path, progress);
  std::erase_if(parts, [](const MeshPart& part) { return part.mesh.triangles.empty(); });
  if (parts.empty()) fail_empty(path);
  PartNames names(' ');
  for (MeshPart& part : parts)
    if (!part.name.empty()) part.name = names.unique(std::move(part.name));
  return parts;
}

TriangleMesh read_mesh(const std::filesystem::path& path) { return load_mesh(path).mesh; }

}  // namespace fieldfab
