/// Winding number of triangles around a point; private to the mesh folder.
#pragma once

#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Generalised winding number of a mesh (Jacobson, Kavan, Sorkine-Hornung 2013): 1 inside a closed
/// mesh that faces outwards, 0 outside, and between them near holes. Distant groups of triangles
/// count as one dipole (Barill et al. 2018); the total error is less than 0.02.
class WindingNumber {
 public:
  explicit WindingNumber(const TriangleMesh& mesh);

  [[nodiscard]] double at(const Vec3& point) const;
  /// Upper bound of the length of the gradient of the winding number within `reach` of `point`, if
  /// no triangle is that near: the sum over groups of area / (2 pi distance^3).
  [[nodiscard]] double steepest(const Vec3& point, double reach) const;

 private:
  struct Group {
    Vec3 centre;                 ///< weighted by area
    Vec3 areas;                  ///< sum of the triangles' area vectors
    double area = 0;             ///< sum of their areas
    double radius = 0;           ///< of a ball around the centre that contains all its triangles
    std::uint32_t first, count;  ///< of the triangles, in order_
    std::uint32_t second = 0;    ///< index of the second half, or 0 if undivided; the first half follows this group
  };
  void divide(std::uint32_t first, std::uint32_t count);

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Group> groups_;
};

}  // namespace fieldfab
