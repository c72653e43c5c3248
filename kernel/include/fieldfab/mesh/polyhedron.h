/// Solids by their corners and triangles, in double precision.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Corners in mm and triangles, anticlockwise seen from outside; closed, unless it comes from a file that is not.
struct Polyhedron {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
  [[nodiscard]] Box bounds() const;  ///< of all vertices; only where there are some
  void add(const Polyhedron& other);
};

Polyhedron moved(const Polyhedron& solid, const Eigen::Affine3d& placement);

/// Joins corners at the same place and drops triangles that have no three of them.
Polyhedron welded(const Polyhedron& solid);

/// In single precision, for mesh_field() and files.
TriangleMesh to_mesh(const Polyhedron& solid);
Polyhedron to_polyhedron(const TriangleMesh& mesh);

}  // namespace fieldfab
