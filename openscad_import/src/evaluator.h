/// Evaluation of a tree's nodes; private.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "arguments.h"
#include "fieldfab/openscad/design.h"
#include "leaf.h"

namespace fieldfab::openscad {

/// Turns nodes of one tree into flat regions and solids.
class Evaluator {
 public:
  Evaluator(const Tree& tree, std::filesystem::path folder, const DesignOptions& options, Progress& progress);

  /// 2 or 3, or 0 if the node draws nothing.
  [[nodiscard]] int dimensions(NodeIndex node) const { return dimensions_[node]; }
  /// The node to start with: the first one marked by `!`, or the root.
  [[nodiscard]] NodeIndex start() const { return start_; }

  /// Returns the solid of a node, placed.
  PartPtr solid(NodeIndex node, const Eigen::Affine3d& placement, int depth = 0);
  /// Returns the flat shape of a node.
  Region flat(NodeIndex node, int depth = 0);

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  void find_dimensions();
  /// Returns the children with that number of dimensions that are not disabled.
  [[nodiscard]] std::vector<NodeIndex> children(const Node& node, int wanted);
  [[nodiscard]] PartPtr united(const Node& node, const Eigen::Affine3d& placement, int depth);
  [[nodiscard]] Region united_flat(const Node& node, int depth);
  void note(const Node& node, const std::string& message);
  /// Number of sides of a circle; 0 for a round one.
  [[nodiscard]] int sides(const Arguments& arguments, double radius, const Node& node);
  [[nodiscard]] static Eigen::Affine3d placement_of(const Arguments& arguments, const Node& node);
  static bool places(const Node& node);

  // solids.cpp
  PartPtr cube(const Arguments& a, const Eigen::Affine3d& placement);
  PartPtr sphere(const Arguments& a, const Node& node, const Eigen::Affine3d& placement);
  PartPtr cylinder(const Arguments& a, const Node& node, const Eigen::Affine3d& placement);
  PartPtr polyhedron(const Arguments& a, const Node& node, const Eigen::Affine3d& placement);
  PartPtr linear_extrude(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth);
  PartPtr rotate_extrude(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth);
  PartPtr imported(const Arguments& a, const Node& node, const Eigen::Affine3d& placement);
  // whole_shapes.cpp
  PartPtr hull(const Node& node, const Eigen::Affine3d& placement, int depth);
  PartPtr minkowski(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth);
  PartPtr sum(const PartPtr& one, const PartPtr& two, const Arguments& a);
  PartPtr resize(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth);
  Region projection(const Arguments& a, const Node& node, int depth);
  // flat_shapes.cpp
  Region primitive(const Arguments& a, const Node& node);
  Region polygon(const Arguments& a);
  Region drawn(NodeIndex node);
  Region resized(const Arguments& a, const Node& node, int depth);

  const Tree& tree_;
  std::filesystem::path folder_;
  DesignOptions options_;
  Progress& progress_;
  std::vector<std::uint8_t> dimensions_;
  NodeIndex start_ = 0;
  std::vector<std::string> notes_;
  std::map<std::string, Region> drawings_;                           ///< by the text of their node
  std::map<std::string, std::shared_ptr<const Polyhedron>> meshes_;  ///< by file and arguments
};

/// Returns the factors that scale a size to the one wanted by resize().
std::vector<double> resize_factors(const std::vector<double>& wanted, const std::vector<double>& automatic,
                                   const std::vector<double>& size);

}  // namespace fieldfab::openscad
