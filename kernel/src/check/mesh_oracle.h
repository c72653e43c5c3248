/// Queries of a mesh, by CGAL.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/check/check.h"

namespace fieldfab {

/// Queries of a valid, closed mesh. Construction takes time linear in the triangles, each query
/// logarithmic time.
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
