/// View-dependent meshes for display: fine near the eye, coarse elsewhere (Keeter 4.3.3).
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Resolution of a DetailMesh.
struct DetailSettings {
  int cells = 24;                        ///< cells along each side of a part, at every level
  int deepest = 8;                       ///< number of levels below the root
  double angle = 0.002;                  ///< permitted visual angle of a cell, radians: about two pixels
  std::size_t most_triangles = 4000000;  ///< limit above which parts outside the view are discarded
};

/// An octree of boxes over a solid; each box is meshed when it is viewed. Not thread-safe: one thread calls refine()
/// and passes the result of parts() to the drawing thread.
///
/// Parts of different levels do not meet exactly; each extends one cell beyond its box, so that no gap is visible.
/// contour() makes a closed mesh.
class DetailMesh {
 public:
  /// A part of the surface. Its mesh never changes, so that a viewer may cache data derived from it.
  struct Part {
    Box box;
    int level;  ///< 0 is the root
    std::shared_ptr<const TriangleMesh> mesh;
  };

  /// Shares ownership of `solid`. Throws Error(bad_input) for bounds that are not finite or have no volume, or settings
  /// out of range.
  DetailMesh(FieldPtr solid, const Box& bounds, const DetailSettings& settings = {});
  ~DetailMesh();

  /// Meshes the parts with the greatest visual error for that eye, a few in parallel. Returns false when all are fine
  /// enough; call parts() in between. The first call meshes the root. Throws Error(cancelled).
  bool refine(const Vec3& eye, Progress& progress = Progress::none());

  /// Returns the available parts to draw for that eye. They cover the solid, and no part lies within another.
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
