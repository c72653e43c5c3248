/// How often triangles wind around a point; private to the mesh folder.
#pragma once

#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// The generalised winding number of a mesh (Jacobson, Kavan, Sorkine-Hornung 2013): 1 inside of a closed mesh that faces
/// outward, 0 outside, and between these near holes. Groups of triangles far away count as one (Barill et al. 2018), which is off
/// by less than 0.02 in all.
class WindingNumber {
 public:
  explicit WindingNumber(const TriangleMesh& mesh);

  [[nodiscard]] double at(const Vec3& point) const;
  /// No less than the length of the gradient of the winding number anywhere within `reach` of `point`, where no triangle is that
  /// near: the sum over groups of area / (2 pi distance^3).
  [[nodiscard]] double steepest(const Vec3& point, double reach) const;

 private:
  struct Group {
    Vec3 centre;                 ///< weighted by area
    Vec3 areas;                  ///< sum of the triangles' area vectors
    double area = 0;             ///< sum of their areas
    double radius = 0;           ///< all its triangles lie within, about the centre
    std::uint32_t first, count;  ///< of the triangles, in order_
    std::uint32_t second = 0;    ///< the other half; the first half follows at once. 0 in groups that are not divided
  };
  void divide(std::uint32_t first, std::uint32_t count);

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Group> groups_;
};

}  // namespace fieldfab
