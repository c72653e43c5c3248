/// A mesh as CGAL sees it.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/check/check.h"

namespace fieldfab {

/// Answers about a valid, closed mesh. Building it takes time linear in the triangles, each question logarithmic.
class MeshOracle {
 public:
  explicit MeshOracle(const TriangleMesh& mesh);
  ~MeshOracle();
  /// Whether the point is strictly inside; a point on the surface is not.
  [[nodiscard]] bool inside(const Vec3& point) const;
  /// Distance to the surface, mm.
  [[nodiscard]] double distance(const Vec3& point) const;

 private:
  struct Cgal;
  std::unique_ptr<Cgal> cgal_;
};

}  // namespace fieldfab
