// Placement of the items in the build of a .3mf file: reads the parts, counts the objects to be
// placed, then places them. Files may nest objects to any depth, so nothing here is recursive.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <deque>
#include <map>
#include <unordered_set>

#include "fieldfab/core/error.h"
#include "fieldfab/core/lower_case.h"
#include "fieldfab/core/text.h"
#include "mesh_file.h"
#include "three_mf_model.h"

namespace fieldfab {
namespace {

constexpr std::uint64_t most_triangles = 0x7fffffff, most_placed = 100'000'000;

/// Returns the name of a part in the archive, without the leading "/".
std::string part_name(std::string_view target) {
  while (target.starts_with('/') || target.starts_with("./")) target.remove_prefix(target[0] == '/' ? 1 : 2);
  return std::string(target);
}

/// Size of an object when placed; sums saturate beyond all limits.
struct Count {
  std::uint64_t vertices = 0, triangles = 0, placed = 0;  ///< `placed` counts objects and components
  void add(const Count& other) {
    constexpr std::uint64_t beyond = std::uint64_t{1} << 50;
    vertices = std::min(vertices + other.vertices, beyond);
    triangles = std::min(triangles + other.triangles, beyond);
    placed = std::min(placed + other.placed, beyond);
  }
};

/// An object reachable from the build.
struct Node {
  const ThreeMfObject* object = nullptr;
  std::uint32_t part = 0, id = 0;
  std::vector<std::uint32_t> children;  ///< indices of nodes, in the order of the object's components
  Count count;
  enum class State : std::uint8_t { fresh, open, counted } state = State::fresh;
};

class Assembly {
 public:
  Assembly(const ZipReader& zip, const std::filesystem::path& path, Progress& progress)
      : zip_(zip), path_(path), progress_(progress) {}

  MeshFromFile read() {
    const std::vector<std::uint32_t> roots = counted();
    MeshFromFile result;
    result.mesh.vertices.reserve(all_.vertices);
    result.mesh.triangles.reserve(all_.triangles);
    for (std::size_t i = 0; i < roots.size(); ++i) place(roots[i], affine(0, models_[0].build[i]), result.mesh);
    std::set<std::string> left_out;
    for (const ThreeMfModel& model : models_) {
      if (model.has_names) left_out.insert("names of objects");
      if (model.has_colours) left_out.insert("colours and materials");
    }
    add_notes(std::move(left_out), result.notes);
    return result;
  }

  std::vector<MeshPart> read_parts(std::vector<std::string>& notes) {
    const std::vector<std::uint32_t> roots = counted();
    std::vector<MeshPart> parts;
    std::map<std::uint32_t, Label> labels;
    std::set<std::string> left_out;
    const std::string other_colours = "colours and materials other than one opaque base material an object";
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const Node& root = nodes_[roots[i]];
      if (root.count.triangles == 0) continue;
      const ThreeMfItem& item = models_[0].build[i];
      const auto [at, is_new] = labels.try_emplace(roots[i]);
      if (is_new) at->second = label_of(roots[i]);
      const Label& label = at->second;
      if (label.loses_names) left_out.insert("names of components");
      if (label.loses_colours) left_out.insert(other_colours);
      MeshPart& part = parts.emplace_back();
      part.name = root.object->name.empty() ? item.part_number : root.object->name;
      part.colour = label.colour;
      part.mesh.vertices.reserve(root.count.vertices);
      part.mesh.triangles.reserve(root.count.triangles);
      place(roots[i], affine(0, item), part.mesh);
    }
    for (const ThreeMfModel& model : models_)
      if (model.has_other_colours) left_out.insert(other_colours);
    add_notes(std::move(left_out), notes);
    return parts;
  }

 private:
  [[noreturn]] void fail(const std::string& how) const { throw Error(ErrorKind::bad_input, path_.string(), how); }

  /// Colour and losses of an object and its descendants.
  struct Label {
    std::optional<Colour> colour;
    bool loses_names = false, loses_colours = false;  ///< whether one name or one colour for all is not enough
  };

  /// Returns the nodes of the build's items, with counts. Throws too_large for more than a mesh or
  /// memory can hold.
  std::vector<std::uint32_t> counted() {
    load(part_name(first_model_part(zip_, path_, progress_)));
    std::vector<std::uint32_t> roots;
    for (const ThreeMfReference& item : models_[0].build) {
      roots.push_back(node_of(0, item));
      count(roots.back());
    }
    for (const std::uint32_t root : roots) all_.add(nodes_[root].count);
    if (roots.empty()) fail("places nothing: its build has no item");
    if (all_.triangles == 0 && unprinted_ > 0) fail("places no object of type 'model', and others are not solids");
    require(all_);
    return roots;
  }

  [[nodiscard]] std::optional<Colour> colour_of(const Node& node) const {
    if (!node.object->property) return std::nullopt;
    const auto& groups = models_[node.part].base_materials;
    const auto group = groups.find(node.object->property->group);
    if (group == groups.end() || node.object->property->index >= group->second.size()) return std::nullopt;
    return group->second[node.object->property->index];
  }

  [[nodiscard]] Label label_of(std::uint32_t root) const {
    std::unordered_set<std::uint32_t> seen{root};
    std::vector<std::uint32_t> open{root};
    std::vector<std::optional<Colour>> colours;  // different colours of meshes
    Label label;
    while (!open.empty()) {
      progress_.check();
      const std::uint32_t here = open.back();
      const Node& node = nodes_[here];
      open.pop_back();
      if (here != root && !node.object->name.empty()) label.loses_names = true;
      if (node.object->printed && !node.object->triangles.empty())
        if (const auto colour = colour_of(node);
            std::ranges::find(colours, colour) == colours.end() && colours.size() < 2)
          colours.push_back(colour);
      for (const std::uint32_t child : node.children)
        if (nodes_[child].count.triangles > 0 && seen.insert(child).second) open.push_back(child);
    }
    label.colour = colour_of(nodes_[root]);
    if (!label.colour && colours.size() == 1) label.colour = colours[0];
    label.loses_colours = colours.size() > 1;
    return label;
  }

  std::uint32_t load(const std::string& name) {
    const auto [at, is_new] = parts_.try_emplace(lower_case(name), static_cast<std::uint32_t>(models_.size()));
    if (is_new) {
      progress_.report(0, "reading the mesh");
      models_.push_back(read_three_mf_model(zip_, name, path_, budget_, progress_));
    }
    return at->second;
  }

  /// Returns the node of the object that a reference in a part points to.
  std::uint32_t node_of(std::uint32_t part, const ThreeMfReference& reference) {
    const std::uint32_t home = reference.part == 0 ? part : load(part_name(models_[part].paths[reference.part - 1]));
    const auto [at, is_new] =
        numbers_.try_emplace(std::pair(home, reference.object), static_cast<std::uint32_t>(nodes_.size()));
    if (!is_new) return at->second;
    const auto found = models_[home].objects.find(reference.object);
    if (found == models_[home].objects.end())
      fail(fmt::format("refers to an object {} that is not there", reference.object));
    nodes_.push_back({&found->second, home, reference.object, {}, {}, Node::State::fresh});
    return at->second;
  }

  /// Counts the content of a node and its descendants. Throws bad_input for an object that contains
  /// itself.
  void count(std::uint32_t root) {
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
      progress_.check();
      const std::uint32_t here = open.back();
      const ThreeMfObject& object = *nodes_[here].object;
      if (nodes_[here].state == Node::State::counted) {  // reached twice before it was counted
        open.pop_back();
        continue;
      }
      if (nodes_[here].state == Node::State::fresh) {
        nodes_[here].state = Node::State::open;
        for (const ThreeMfReference& component : object.components) {
          const std::uint32_t child = node_of(nodes_[here].part, component);
          nodes_[here].children.push_back(child);
          if (nodes_[child].state == Node::State::open)
            fail(fmt::format("has an object {} that is a component of itself", nodes_[child].id));
          if (nodes_[child].state == Node::State::fresh) open.push_back(child);
        }
        if (open.back() != here) continue;
      }
      Count sum{0, 0, 1};
      if (object.printed)
        sum.vertices = object.vertices.size(), sum.triangles = object.triangles.size();
      else if (!object.triangles.empty())
        ++unprinted_;
      for (const std::uint32_t child : nodes_[here].children) sum.add(nodes_[child].count);
      if (sum.triangles == 0) sum = {};
      nodes_[here].count = sum;
      nodes_[here].state = Node::State::counted;
      open.pop_back();
    }
  }

  void require(const Count& all) const {
    if (all.triangles > most_triangles || all.vertices > most_triangles)
      throw Error(
          ErrorKind::too_large, path_.string(),
          fmt::format("its components and items would make more than {} triangles or vertices", most_triangles));
    if (all.placed > most_placed)
      throw Error(ErrorKind::too_large, path_.string(), fmt::format("places more than {} components", most_placed));
    // This mesh and its merging: a second mesh, the vertices' new numbers, and a hash table of
    // them.
    constexpr std::uint64_t vertex = 12 + 12 + 4 + 48, triangle = 12 + 12;
    require_memory(vertex * all.vertices + triangle * all.triangles, "the mesh of " + path_.string());
  }

  Eigen::Affine3d affine(std::uint32_t part, const ThreeMfReference& reference) const {
    Eigen::Affine3d result;
    const ThreeMfTransform& t = reference.transform;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        result(row, column) = t[static_cast<std::size_t>(3 * column + row)] * (column == 3 ? models_[part].unit : 1);
    result.makeAffine();
    if (result.linear().determinant() == 0)
      fail(fmt::format("has a transform that flattens object {}", reference.object));
    return result;
  }

  void place(std::uint32_t root, const Eigen::Affine3d& transform, TriangleMesh& mesh) {
    struct Level {
      std::uint32_t node;
      std::size_t next_child = 0;
      Eigen::Affine3d transform;
    };
    // A vector would copy hundreds of thousands of elements as it grows.
    std::deque<Level> levels{{root, 0, transform}};
    while (!levels.empty()) {
      Level& level = levels.back();
      const Node& node = nodes_[level.node];
      if (node.count.triangles == 0) {
        levels.pop_back();
        continue;
      }
      progress_.check();
      if (level.next_child == 0) place_mesh(node, level.transform, mesh);
      if (level.next_child == node.children.size()) {
        levels.pop_back();
        continue;
      }
      const std::size_t child = level.next_child++;
      levels.push_back({node.children[child], 0, level.transform * affine(node.part, node.object->components[child])});
    }
  }

  void place_mesh(const Node& node, const Eigen::Affine3d& transform, TriangleMesh& mesh) {
    if (!node.object->printed) return;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double unit = models_[node.part].unit;
    const bool mirrors = transform.linear().determinant() < 0;
    const auto look = [&](std::size_t i) {
      if (i % 16384 != 0) return;
      progress_.check();
      progress_.report(0.5 * static_cast<double>(placed_) / static_cast<double>(all_.triangles), "reading the mesh");
    };
    for (std::size_t i = 0; i < node.object->vertices.size(); ++i) {
      look(i);
      const auto& [x, y, z] = node.object->vertices[i];
      const Vec3 p = transform * (unit * Vec3(x, y, z));
      mesh.vertices.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
    for (std::size_t i = 0; i < node.object->triangles.size(); ++i) {
      look(i);
      auto [a, b, c] = node.object->triangles[i];
      if (mirrors) std::swap(b, c);
      mesh.triangles.push_back({first + a, first + b, first + c});
      ++placed_;
    }
  }

  void add_notes(std::set<std::string> left_out, std::vector<std::string>& notes) const {
    const std::string name = path_.filename().string();
    std::size_t objects = 0;
    for (const ThreeMfModel& model : models_) {
      left_out.insert(model.left_out.begin(), model.left_out.end());
      objects += model.objects.size();
    }
    if (!left_out.empty()) notes.push_back(fmt::format("{}: left out: {}", name, fmt::join(left_out, ", ")));
    if (unprinted_ > 0)
      notes.push_back(fmt::format("{}: left out: {} of another type than 'model'", name, objects_in_words(unprinted_)));
    if (objects > nodes_.size())
      notes.push_back(fmt::format("{}: left out: {} that the build does not place", name,
                                  objects_in_words(objects - nodes_.size())));
  }
  static std::string objects_in_words(std::size_t count) {
    return fmt::format("{} {}", count, count == 1 ? "object" : "objects");
  }

  const ZipReader& zip_;
  const std::filesystem::path& path_;
  Progress& progress_;
  ThreeMfBudget budget_;
  std::deque<ThreeMfModel> models_;             ///< references stay valid when more are added
  std::map<std::string, std::uint32_t> parts_;  ///< by name in lower case
  std::vector<Node> nodes_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;  ///< of nodes, by part and id
  std::size_t unprinted_ = 0;
  Count all_;                 ///< total of the build
  std::uint64_t placed_ = 0;  ///< number of triangles so far
};

}  // namespace

MeshFromFile read_3mf(std::string_view bytes, const std::filesystem::path& path, Progress& progress) {
  const ZipReader zip(bytes, path);
  return Assembly(zip, path, progress).read();
}

std::vector<MeshPart> read_3mf_parts(std::string_view bytes, const std::filesystem::path& path, Progress& progress,
                                     std::vector<std::string>& notes) {
  const ZipReader zip(bytes, path);
  return Assembly(zip, path, progress).read_parts(notes);
}

}  // namespace fieldfab
