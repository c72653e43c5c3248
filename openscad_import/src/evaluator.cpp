#include "evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "imports.h"

namespace fieldfab::openscad {
namespace {

constexpr int deepest = 2000;  // nodes within nodes that join several; chains of single children do not count

bool is_one_of(const std::string& name, std::initializer_list<const char*> known) {
  return std::any_of(known.begin(), known.end(), [&](const char* one) { return name == one; });
}

bool is_solid(const std::string& name) {
  return is_one_of(name, {"cube", "sphere", "cylinder", "polyhedron", "surface", "linear_extrude", "rotate_extrude"});
}
bool is_flat(const std::string& name) {
  return is_one_of(name, {"square", "circle", "polygon", "text", "projection", "offset"});
}
bool is_joint(const std::string& name) {
  return is_one_of(name, {"group", "union", "intersection", "difference", "hull", "minkowski", "resize", "render",
                          "color", "multmatrix", "translate", "rotate", "scale", "mirror"});
}

}  // namespace

Evaluator::Evaluator(const Tree& tree, std::filesystem::path folder, const DesignOptions& options, Progress& progress)
    : tree_(tree), folder_(std::move(folder)), options_(options), progress_(progress) {
  find_dimensions();
  for (NodeIndex i = 0; i < tree.nodes.size(); ++i)
    if (tree.nodes[i].root) {
      start_ = i;
      break;
    }
}

void Evaluator::find_dimensions() {
  dimensions_.assign(tree_.nodes.size(), 0);
  for (std::size_t i = tree_.nodes.size(); i-- > 0;) {  // children come after their parents
    const Node& node = tree_.nodes[i];
    const auto is_live = [&](NodeIndex child) {
      return !tree_.nodes[child].background && !tree_.nodes[child].disabled;
    };
    const bool is_made_of_children = is_one_of(node.name, {"linear_extrude", "rotate_extrude", "projection", "offset"});
    if (is_made_of_children && std::none_of(node.children.begin(), node.children.end(), is_live)) {
      continue;  // 0 dimensions: the node is ignored
    } else if (is_solid(node.name)) {
      dimensions_[i] = 3;
    } else if (is_flat(node.name)) {
      dimensions_[i] = 2;
    } else if (node.name == "import") {
      dimensions_[i] = is_flat_file(Arguments(tree_, node).text("file", "")) ? 2 : 3;
    } else if (is_joint(node.name)) {
      for (const NodeIndex child : node.children)
        if (dimensions_[i] == 0 && is_live(child)) dimensions_[i] = dimensions_[child];
    } else {
      throw Error(ErrorKind::bad_input, tree_.place(node), fmt::format("'{:.60}' is not known", node.name));
    }
  }
}

std::vector<NodeIndex> Evaluator::children(const Node& node, int wanted) {
  std::vector<NodeIndex> all;
  for (const NodeIndex child : node.children) {
    const Node& below = tree_.nodes[child];
    if (below.background || below.disabled || dimensions_[child] == 0) continue;
    if (dimensions_[child] == wanted)
      all.push_back(child);
    else
      note(below, fmt::format("{} is {}D among {}D shapes, and left out as OpenSCAD does", below.name,
                              int{dimensions_[child]}, wanted));
  }
  return all;
}

void Evaluator::note(const Node& node, const std::string& message) {
  const std::string line = tree_.place(node) + ": " + message;
  if (std::find(notes_.begin(), notes_.end(), line) == notes_.end()) notes_.push_back(line);
}

bool Evaluator::places(const Node& node) {
  return is_one_of(node.name, {"multmatrix", "translate", "rotate", "scale", "mirror"});
}

Eigen::Affine3d Evaluator::placement_of(const Arguments& a, const Node& node) {
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  if (node.name == "multmatrix") {
    placement.matrix() = a.matrix();
    return placement;
  }
  const auto vector = [&](const char* name, double rest) {
    const Value* given = a.find(name);
    for (const Argument& argument : node.arguments)
      if (given == nullptr && argument.name.empty()) given = &argument.value;
    Vec3 v = Vec3::Constant(rest);
    if (given == nullptr) return v;
    if (const double* number = given->number()) return Vec3(Vec3::Constant(*number));
    const std::vector<double> numbers = a.list_of_numbers(*given, name);
    for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 3); ++i)
      v[static_cast<Eigen::Index>(i)] = numbers[i];
    if (!v.allFinite()) a.fail("has numbers that are not finite");
    return v;
  };
  if (node.name == "translate") {
    placement.translation() = vector("v", 0);
  } else if (node.name == "scale") {
    placement.linear() = vector("v", 1).asDiagonal();
  } else if (node.name == "mirror") {
    const Vec3 normal = vector("v", 0);
    if (normal.norm() > 0) placement.linear() -= 2 * normal.normalized() * normal.normalized().transpose();
  } else {  // rotate
    const Value* angle = a.find("a");
    for (const Argument& argument : node.arguments)
      if (angle == nullptr && argument.name.empty()) angle = &argument.value;
    if (angle != nullptr && angle->number() != nullptr) {
      const Vec3 axis = a.find("v") != nullptr ? vector("v", 0) : Vec3::UnitZ();
      if (axis.norm() > 0)
        placement.linear() =
            Eigen::AngleAxisd(*angle->number() * radians_per_degree, axis.normalized()).toRotationMatrix();
    } else {
      const Vec3 turns = vector("a", 0) * radians_per_degree;
      placement = Eigen::AngleAxisd(turns.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(turns.y(), Vec3::UnitY()) *
                  Eigen::AngleAxisd(turns.x(), Vec3::UnitX());
    }
  }
  return placement;
}

int Evaluator::sides(const Arguments& arguments, double radius, const Node& node) {
  if (options_.smooth) return 0;
  constexpr double most = 1440;
  const double wanted = arguments.fragments(radius);
  if (wanted <= most) return static_cast<int>(wanted);
  note(node, fmt::format("{} with {:.0f} sides is taken as round", node.name, wanted));
  return 0;
}

PartPtr Evaluator::united(const Node& node, const Eigen::Affine3d& placement, int depth) {
  std::vector<PartPtr> parts;
  for (const NodeIndex child : children(node, 3)) parts.push_back(solid(child, placement, depth));
  return unite(std::move(parts));
}

Region Evaluator::united_flat(const Node& node, int depth) {
  std::vector<Region> regions;
  for (const NodeIndex child : children(node, 2)) regions.push_back(flat(child, depth));
  return regions.empty() ? Region{} : unite(regions);
}

PartPtr Evaluator::solid(NodeIndex index, const Eigen::Affine3d& outer, int depth) {
  progress_.check();
  Eigen::Affine3d placement = outer;
  const Node* node = &tree_.nodes[index];
  // Chains of nodes with one child each are followed in a loop, without recursion.
  for (;;) {
    const bool is_placing = places(*node);
    if (!is_placing && !is_one_of(node->name, {"group", "union", "intersection", "difference", "render", "color"}))
      break;
    if (is_placing) placement = placement * placement_of(Arguments(tree_, *node), *node);
    const std::vector<NodeIndex> below = children(*node, 3);
    if (below.size() != 1 || (is_one_of(node->name, {"intersection", "difference"}) && node->children.size() > 1))
      break;
    if (dimensions_[below.front()] != 3) return nothing();
    node = &tree_.nodes[below.front()];
  }
  if (depth > deepest)
    throw Error(ErrorKind::bad_input, tree_.place(*node),
                fmt::format("is more than {} nodes deep within others", deepest));
  const Arguments a(tree_, *node);
  const std::string& name = node->name;
  if (name == "cube") return cube(a, placement);
  if (name == "sphere") return sphere(a, *node, placement);
  if (name == "cylinder") return cylinder(a, *node, placement);
  if (name == "polyhedron") return polyhedron(a, *node, placement);
  if (name == "import" || name == "surface") return imported(a, *node, placement);
  if (name == "linear_extrude") return linear_extrude(a, *node, placement, depth + 1);
  if (name == "rotate_extrude") return rotate_extrude(a, *node, placement, depth + 1);
  if (name == "hull") return hull(*node, placement, depth + 1);
  if (name == "minkowski") return minkowski(a, *node, placement, depth + 1);
  if (name == "resize") return resize(a, *node, placement, depth + 1);
  if (name != "intersection" && name != "difference") return united(*node, placement, depth + 1);
  std::vector<PartPtr> parts;
  bool first = true;
  for (const NodeIndex child : node->children) {
    const Node& below = tree_.nodes[child];
    if (below.background || below.disabled) continue;
    if (dimensions_[child] == 3)
      parts.push_back(solid(child, placement, depth + 1));
    else if (name == "intersection" || (first && dimensions_[child] == 0))
      return nothing();  // a difference from nothing, or an intersection with nothing
    else if (dimensions_[child] == 2)
      note(below, fmt::format("{} is 2D among 3D shapes, and left out as OpenSCAD does", below.name));
    first = false;
  }
  return name == "difference" ? subtract(std::move(parts)) : intersect(std::move(parts));
}

Region Evaluator::flat(NodeIndex index, int depth) {
  progress_.check();
  Eigen::Affine2d placement = Eigen::Affine2d::Identity();
  const Node* node = &tree_.nodes[index];
  for (;;) {
    const bool is_placing = places(*node);
    if (!is_placing && !is_one_of(node->name, {"group", "union", "intersection", "difference", "render", "color"}))
      break;
    if (is_placing) {
      const Eigen::Matrix4d m = placement_of(Arguments(tree_, *node), *node).matrix();
      Eigen::Affine2d here = Eigen::Affine2d::Identity();
      here.linear() = m.topLeftCorner<2, 2>();
      here.translation() = m.topRightCorner<2, 1>();
      placement = placement * here;
    }
    const std::vector<NodeIndex> below = children(*node, 2);
    if (below.size() != 1 || (is_one_of(node->name, {"intersection", "difference"}) && node->children.size() > 1))
      break;
    index = below.front();
    node = &tree_.nodes[index];
  }
  if (depth > deepest)
    throw Error(ErrorKind::bad_input, tree_.place(*node),
                fmt::format("is more than {} nodes deep within others", deepest));
  const Arguments a(tree_, *node);
  const std::string& name = node->name;
  const auto make = [&]() -> Region {
    if (name == "square" || name == "circle") return primitive(a, *node);
    if (name == "polygon") return polygon(a);
    if (name == "text" || name == "import") return drawn(index);
    if (name == "projection") return projection(a, *node, depth + 1);
    if (name == "offset") {
      const Value* r = a.find("r");
      const double distance = r != nullptr ? a.number("r", 0) : a.number("delta", 0);
      if (!std::isfinite(distance)) a.fail("the distance is not finite");
      const Corner corner = r != nullptr ? Corner::round : a.truth("chamfer", false) ? Corner::chamfer : Corner::mitre;
      const Region region = united_flat(*node, depth + 1);
      const int count = sides(a, std::abs(distance), *node);
      return region.empty() || distance == 0 ? region : offset(region, distance, corner, count == 0 ? 720 : count);
    }
    if (name == "hull") {
      std::vector<Region> regions;
      for (const NodeIndex child : children(*node, 2)) regions.push_back(flat(child, depth + 1));
      return hull_of(regions);
    }
    if (name == "resize") return resized(a, *node, depth + 1);
    std::vector<Region> regions;
    if (name == "intersection" || name == "difference" || name == "minkowski") {
      bool first = true;
      for (const NodeIndex child : node->children) {
        const Node& below = tree_.nodes[child];
        if (below.background || below.disabled) continue;
        if (dimensions_[child] == 2)
          regions.push_back(flat(child, depth + 1));
        else if (name == "intersection" || (first && name == "difference" && dimensions_[child] == 0))
          return {};
        first = false;
      }
      if (name == "difference") return subtract(regions);
      if (name == "intersection") return openscad::intersect(regions);
      if (regions.empty()) return {};
      Region total = regions.front();
      for (std::size_t i = 1; i < regions.size(); ++i) total = openscad::minkowski(total, regions[i]);
      return total;
    }
    return united_flat(*node, depth + 1);
  };
  return moved(make(), placement);
}

}  // namespace fieldfab::openscad
