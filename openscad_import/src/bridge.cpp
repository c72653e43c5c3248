#include "fieldfab/openscad/bridge.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"
#include "programs.h"

namespace fieldfab::openscad {
namespace {

constexpr const char* marker = "fieldfab:";
constexpr double cells_a_side = 64;  // default; OpenSCAD takes minutes for much finer meshes

/// Request of a design: "fieldfab:KIND:KEY:[...]".
struct Request {
  std::string kind, key, words;
  List values;
};

std::string decoded(const Value& codes) {
  std::string words;
  if (codes.list() == nullptr) return words;
  for (const Value& code : *codes.list()) {  // as UTF-8
    const double* number = code.number();
    const auto c =
        number != nullptr && *number >= 0 && *number < 0x110000 ? static_cast<std::uint32_t>(*number) : 0xFFFDU;
    const auto add = [&](std::uint32_t byte) { words += static_cast<char>(byte); };
    if (c < 0x80) {
      add(c);
    } else if (c < 0x800) {
      add(0xC0 | c >> 6), add(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
      add(0xE0 | c >> 12), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
    } else {
      add(0xF0 | c >> 18), add(0x80 | (c >> 12 & 0x3F)), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
    }
  }
  return words;
}

/// Finds the request of a node, if its first child is a text with one.
bool find_request(const Tree& tree, const Node& node, Request& request) {
  if (node.name != "group" || node.children.empty()) return false;
  const Node& first = tree.nodes[node.children.front()];
  if (first.name != "text" || first.arguments.empty() || first.arguments[0].value.text() == nullptr) return false;
  const std::string& text = *first.arguments[0].value.text();
  if (!text.starts_with(marker)) return false;
  const std::size_t kind = std::string_view(marker).size(), key = text.find(':', kind), words = text.find(':', key + 1);
  if (key == std::string::npos || words == std::string::npos) return false;
  request.kind = text.substr(kind, key - kind);
  request.key = text.substr(key + 1, words - key - 1);
  request.words = text.substr(words + 1);
  if (request.key.empty() || request.key.find_first_not_of("0123456789") != std::string::npos) return false;
  const Tree parsed = parse_csg("wanted(" + request.words + ");", tree.file);
  if (parsed.nodes.size() != 2 || parsed.nodes[1].arguments.empty() ||
      parsed.nodes[1].arguments[0].value.list() == nullptr)
    return false;
  request.values = *parsed.nodes[1].arguments[0].value.list();
  request.values.resize(3);
  return true;
}

std::string fingerprint(std::string_view bytes) {  // FNV-1a
  std::uint64_t sum = 14695981039346656037ULL;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", sum);
}

class Cache {
 public:
  Cache(const std::filesystem::path& design, Tree tree, Progress& progress)
      : design_(std::filesystem::absolute(design)),
        folder_(design_.parent_path() / "fieldfab-cache"),
        tree_(std::move(tree)),
        progress_(progress) {
    report_.sources.push_back(design_);
  }

  CacheReport refresh() {
    // Inner requests come first, since the outer ones need their meshes.
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
      Request request;
      if (!find_request(tree_, tree_.nodes[i], request)) continue;
      const std::filesystem::path mesh = folder_ / (request.key + ".stl");
      provide(request, tree_.nodes[i], mesh);
      Node& node = tree_.nodes[i];
      node.name = "import";
      node.arguments = {{"file", {mesh.string()}}};
      node.children.clear();
    }
    return std::move(report_);
  }

 private:
  void provide(const Request& request, const Node& node, const std::filesystem::path& mesh) {
    const std::string content = fingerprint(content_of(request, node));
    const std::filesystem::path note = folder_ / (request.key + ".txt");
    auto& known = contents_[request.key];
    if (!known.empty() && known != content)
      throw Error(ErrorKind::bad_input, design_.string(),
                  fmt::format("two uses of {} differ in their children only: give one of them another name = \"...\"",
                              request.kind));
    if (known == content) return;
    known = content;
    if (std::filesystem::exists(mesh) && std::filesystem::exists(note) && read_file(note) == content) {
      ++report_.kept;
      return;
    }
    const fieldfab::Solid solid = solid_of(request, node);
    const Box bounds = working_bounds(solid, wanted_bounds(request), progress_);
    double voxel = bounds.size().maxCoeff() / cells_a_side;
    if (const double* wanted = request.values[2].number()) voxel = *wanted;
    if (!(voxel > 0) || !std::isfinite(voxel)) fail(request, "voxel must be above 0 mm");
    const TriangleMesh made = contour(*solid.field, bounds, {voxel, -1, true}, progress_);
    if (made.triangles.empty()) fail(request, "there is no solid");
    std::filesystem::create_directories(folder_);
    // The note of an older mesh must not remain beside this mesh, even if the power fails between
    // the two writes.
    if (std::filesystem::exists(note)) write_file(note, "");
    write_mesh(made, mesh, progress_);
    write_file(note, content);
    ++report_.made;
  }

  [[noreturn]] void fail(const Request& request, const std::string& message) const {
    throw Error(ErrorKind::bad_input, design_.string(), fmt::format("{}: {}", request.kind, message));
  }

  [[nodiscard]] std::filesystem::path source(const Request& request) const {
    return design_.parent_path() / decoded(request.values[0]);
  }

  /// Everything that the mesh depends on.
  std::string content_of(const Request& request, const Node& node) {
    std::string content = "1 " + request.kind + request.words;
    if (request.kind == "file") {
      const std::filesystem::path path = source(request);
      report_.sources.push_back(path);
      content += path.string();
      if (!std::filesystem::is_directory(path)) {
        require_regular_file(path);
        content += fingerprint(read_file(path));
      } else
        for (const auto& entry : std::filesystem::directory_iterator(path)) {  // a folder of slices
          const auto time = std::filesystem::last_write_time(entry).time_since_epoch().count();
          content += fmt::format("{} {} ", entry.path().filename().string(), time);
        }
    }
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      content += print_csg(tree_, node.children[i]);
      add_imports(node.children[i], content);
    }
    return content;
  }
  /// Adds the content of files imported below a node, since their names stay the same.
  void add_imports(NodeIndex first, std::string& content) {
    std::vector<NodeIndex> open{first};
    while (!open.empty()) {
      const Node& node = tree_.nodes[open.back()];
      open.pop_back();
      open.insert(open.end(), node.children.begin(), node.children.end());
      for (const Argument& argument : node.arguments)
        if (argument.name == "file" && argument.value.text() != nullptr) {
          const std::filesystem::path path = design_.parent_path() / *argument.value.text();
          if (!std::filesystem::is_regular_file(path)) continue;
          content += fingerprint(read_file(path));
          report_.sources.push_back(path);
        }
    }
  }

  [[nodiscard]] std::optional<Box> wanted_bounds(const Request& request) const {
    if (request.kind != "frep" || request.values[1].list() == nullptr) return std::nullopt;
    const List& list = *request.values[1].list();
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < 6; ++i) {
      const double* number = i < list.size() ? list[i].number() : nullptr;
      if (number == nullptr) fail(request, "bounds must be [x0, y0, z0, x1, y1, z1]");
      numbers[i] = *number;
    }
    return Box{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
  }

  fieldfab::Solid solid_of(const Request& request, const Node& node) {
    OpenSettings settings;
    settings.formats = &all_formats();
    if (request.kind == "frep")
      return united(parse_model(decoded(request.values[0]), "frep", design_.parent_path(), settings, progress_));
    if (request.kind == "file") {
      if (const double* threshold = request.values[1].number()) settings.options = {{"threshold", *threshold}};
      return united(open_model(source(request), settings, progress_));
    }
    const double* size = request.values[1].number();
    if (size == nullptr || !std::isfinite(*size)) fail(request, "its size must be a number of mm");
    std::vector<FieldPtr> solids;
    for (const NodeIndex index : shapes_of(node)) {
      Tree child;
      child.file = tree_.file;
      child = subtree(index);
      const auto design = make_design(child, design_.parent_path(), {}, progress_);
      report_.notes.insert(report_.notes.end(), design->notes.begin(), design->notes.end());
      if (design->flat) fail(request, "takes solids, not flat shapes");
      if (design->field != nullptr) solids.push_back(design->field);
    }
    if (solids.empty()) fail(request, "has no children");
    return fieldfab::solid_of(joined(request, solids, *size), "design");
  }

  /// Returns the shapes passed to a module. OpenSCAD wraps them in groups.
  [[nodiscard]] std::vector<NodeIndex> shapes_of(const Node& node) const {
    std::vector<NodeIndex> shapes(node.children.begin() + 1, node.children.end());
    while (shapes.size() == 1 && tree_.nodes[shapes.front()].name == "group" &&
           !tree_.nodes[shapes.front()].children.empty()) {
      const std::vector<NodeIndex> inner = tree_.nodes[shapes.front()].children;
      shapes = inner;
    }
    return shapes;
  }

  /// Returns a node and its descendants as a separate tree.
  [[nodiscard]] Tree subtree(NodeIndex node) const { return parse_csg(print_csg(tree_, node), tree_.file); }

  [[nodiscard]] FieldPtr joined(const Request& request, std::vector<FieldPtr> solids, double size) const {
    using E = frep::Expression;
    namespace shapes = frep::shapes;
    const auto join = [&](const auto& rule) {
      if (!(size > 0)) fail(request, "its size must be above 0 mm");
      const FieldPtr formula = frep::make_field(rule(E::x(), E::y(), E(size))), none = frep::make_field(E(0.0));
      FieldPtr total = solids.front();
      for (std::size_t i = 1; i < solids.size(); ++i) total = map(formula, total, solids[i], none);
      return total;
    };
    const std::string& kind = request.kind;
    if (kind == "smooth_union")
      return join([](const E& a, const E& b, const E& r) { return shapes::smooth_unite(a, b, r); });
    if (kind == "smooth_difference")
      return join([](const E& a, const E& b, const E& r) { return shapes::smooth_subtract(a, b, r); });
    if (kind == "smooth_intersection")
      return join([](const E& a, const E& b, const E& r) { return shapes::smooth_intersect(a, b, r); });
    if (kind == "chamfer_union")
      return join([](const E& a, const E& b, const E& r) { return shapes::chamfer_unite(a, b, r); });
    if (kind == "chamfer_difference")
      return join([](const E& a, const E& b, const E& r) { return shapes::chamfer_subtract(a, b, r); });
    if (kind == "chamfer_intersection")
      return join([](const E& a, const E& b, const E& r) { return shapes::chamfer_intersect(a, b, r); });
    FieldPtr all = solids.front();
    for (std::size_t i = 1; i < solids.size(); ++i) all = unite(all, solids[i]);
    if (kind == "offset") return offset(all, size);
    if (kind == "shell") return shell(all, size);
    fail(request, "is not known to this version of fieldfab");
  }

  std::filesystem::path design_, folder_;
  Tree tree_;
  Progress& progress_;
  CacheReport report_;
  std::map<std::string, std::string> contents_;
};

}  // namespace

namespace {

/// Returns the message with the name of the wanted file instead of that of the temporary one.
std::string with_name(std::string message, const std::filesystem::path& temporary,
                      const std::filesystem::path& wanted) {
  const std::string name = std::filesystem::absolute(temporary).string();
  for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
    message.replace(at, name.size(), wanted.string());
  return message;
}

}  // namespace

CacheReport refresh_cache(const std::filesystem::path& design, Progress& progress) {
  require_regular_file(design);
  const std::filesystem::path library = std::filesystem::absolute(design).parent_path() / "fieldfab.scad";
  if (!std::filesystem::exists(library) && read_file(design).find("fieldfab.scad") != std::string::npos)
    write_file(library, library_text());
  const TemporaryFolder temporary;
  const std::filesystem::path csg = temporary.path() / "design.csg";
  run_openscad(design, csg, progress, {"-D", "$fieldfab_finding=true"});
  return Cache(design, parse_csg(read_file(csg), design.string()), progress).refresh();
}

void export_design(const std::filesystem::path& design, const std::filesystem::path& output, Progress& progress) {
  PendingFile file(output);
  try {
    run_openscad(design, file.temporary(), progress);
  } catch (const Error& error) {
    throw Error(error.kind(), "", with_name(error.what(), file.temporary(), output));
  }
  if (std::filesystem::is_empty(file.temporary()))
    throw Error(ErrorKind::io, output.string(), "OpenSCAD wrote nothing");
  file.commit();
}

}  // namespace fieldfab::openscad
