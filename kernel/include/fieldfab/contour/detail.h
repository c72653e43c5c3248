/// Meshes for looking at: fine where the eye is near, coarse elsewhere (Keeter 4.3.3).
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// How fine a DetailMesh becomes.
struct DetailSettings {
  int cells = 24;                        ///< along each side of a part, at every level
  int deepest = 8;                       ///< levels below the whole
  double angle = 0.002;                  ///< radians that a cell may fill in the eye: about two pixels
  std::size_t most_triangles = 4000000;  ///< parts that are not looked at are dropped beyond this
};

/// A solid divided into parts, an octree of boxes, each of which is meshed by itself when someone looks at it. Not for many
/// threads at once: one thread refines, and hands what parts() gives to the one that draws.
///
/// Parts of different levels do not meet exactly; each reaches a cell beyond its box, so that no gap shows. For a mesh that is
/// closed, use contour().
class DetailMesh {
 public:
  /// A part of the surface. Its mesh never changes, so whoever draws it may keep what was made from it.
  struct Part {
    Box box;
    int level;  ///< 0 is the whole
    std::shared_ptr<const TriangleMesh> mesh;
  };

  /// Throws bad_input for bounds that are not finite or have no size, or settings out of range.
  DetailMesh(FieldPtr solid, const Box& bounds, const DetailSettings& settings = {});
  ~DetailMesh();

  /// Meshes the parts that the eye misses most, a few in parallel; call it until it returns false, and show parts() in between.
  /// The first call meshes the whole, coarsely. Throws cancelled.
  bool refine(const Vec3& eye, Progress& progress = Progress::none());

  /// What to draw for that eye with what is there: parts that cover the solid, none of them within another.
  [[nodiscard]] std::vector<Part> parts(const Vec3& eye) const;

 private:
  struct Node;
  void mesh(const std::vector<Node*>& nodes, Progress& progress);
  [[nodiscard]] double coarseness(const Node& node, const Vec3& eye) const;
  void divide(Node& node);
  void forget(Node& node, const Vec3& eye);

  DetailSettings settings_;
  std::unique_ptr<Node> root_;
  std::size_t triangles_ = 0;
};

}  // namespace fieldfab
