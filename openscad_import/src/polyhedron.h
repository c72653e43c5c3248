/// Solids by their corners and triangles.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "flat.h"

namespace fieldfab::openscad {

using Triangle = std::array<std::uint32_t, 3>;

/// Corners in mm and triangles, anticlockwise seen from outside; closed, unless it comes from a file or a polyhedron() that is
/// not.
struct Polyhedron {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  [[nodiscard]] bool empty() const { return triangles.empty(); }
  [[nodiscard]] Box bounds() const;  ///< of all vertices; only where there are some
  void add(const Polyhedron& other);
};

/// normal * p <= offset; the normal has length 1.
struct Plane {
  Vec3 normal;
  double offset;
};

Polyhedron moved(const Polyhedron& solid, const Eigen::Affine3d& placement);

/// Joins corners at the same place and drops triangles that have no three of them.
Polyhedron welded(const Polyhedron& solid);

/// In single precision, for mesh_field() and files.
TriangleMesh to_mesh(const Polyhedron& solid);
Polyhedron to_polyhedron(const TriangleMesh& mesh);

/// The convex hull; empty where the points lie in a plane.
Polyhedron convex_hull(std::span<const Vec3> points);
/// The planes of a convex polyhedron's faces, each once.
std::vector<Plane> planes_of(const Polyhedron& convex);
/// Whether no corner is beyond the plane of a triangle, by more than rounding.
bool is_convex(const Polyhedron& solid);

/// Outlines in layers, joined by triangles; `place` tells where a point of the flat shape is in each layer of 0 to `steps`. With
/// caps at both ends unless told otherwise. Four-sided faces are divided by their shorter diagonal; where both are as long, by
/// that which goes forwards along the outline as it goes up, or by the other.
struct SweepChoices {
  bool caps = true, forwards_if_equal = false;
};
Polyhedron sweep(const Region& region, int steps, const std::function<Vec3(const Vec2&, int)>& place,
                 const SweepChoices& choices = {});
/// Outlines in the half plane x >= 0 turned about z, first at the angle `first` and then by `step` radians `steps` times; a full
/// turn closes itself.
Polyhedron turned(const Region& profile, double first, double step, int steps, bool full);

/// Where a plane z = 0 cuts it.
Region slice(const Polyhedron& solid);
/// Its shadow along z.
Region shadow(const Polyhedron& solid);

}  // namespace fieldfab::openscad
