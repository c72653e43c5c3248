/// Polyhedra in double precision.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Vertices in mm and triangles, counter-clockwise seen from outside. Closed, unless it comes from an open mesh file.
struct Polyhedron {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
  [[nodiscard]] Box bounds() const;  ///< bounding box of all vertices. Precondition: there is at least one
  /// Appends the vertices and triangles of `other`; does not compute a union.
  void add(const Polyhedron& other);
};

/// Applies an affine map. Reverses the triangles if the map mirrors.
Polyhedron moved(const Polyhedron& solid, const Eigen::Affine3d& placement);

/// Merges vertices at equal positions and removes triangles with fewer than three different vertices.
Polyhedron welded(const Polyhedron& solid);

/// Rounds to single precision, for mesh_field() and files.
TriangleMesh to_mesh(const Polyhedron& solid);
/// Converts to double precision, without loss.
Polyhedron to_polyhedron(const TriangleMesh& mesh);

}  // namespace fieldfab
