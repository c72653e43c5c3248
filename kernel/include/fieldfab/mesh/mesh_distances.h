/// Signed distances to a mesh at the points of a lattice, all at once: where many are wanted, hundreds of times faster than a
/// mesh_field()'s.
#pragma once

#include <array>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Where distances are wanted: at origin + spacing * (i, j, k).
struct DistanceLattice {
  Vec3 origin = Vec3::Zero();
  double spacing = 1;         ///< mm
  std::array<int, 3> size{};  ///< points along x, y and z, 2 or more
  [[nodiscard]] double points() const { return 1.0 * size[0] * size[1] * size[2]; }
};

/// Triangles that close a mesh: of every edge that is passed more often one way than the other. A rim that is one loop is divided
/// between its own vertices; others, and very long ones, get triangles to their middle. Empty for a closed mesh; in the mesh's
/// own vertices and `middles`, which come after them. Where the mesh has vertices at the same place these are not one
/// (read_mesh() has merged them).
struct Lids {
  std::size_t rims = 0, edges = 0;  ///< how many, and of how many edges
  std::vector<std::array<float, 3>> middles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double area = 0;   ///< mm2
  double folds = 1;  ///< the most that a lid to a middle is larger than its flat shadow: above 1 where it lies over itself

  /// Whether they close holes; of mere pieces of a surface lids are the pieces again, from behind.
  [[nodiscard]] bool are_small(const TriangleMesh& mesh) const { return area <= 0.5 * mesh.area(); }
  /// Whether there are some, and as a surface they are as good as the mesh: small, and none lies over itself.
  [[nodiscard]] bool are_good(const TriangleMesh& mesh) const { return !triangles.empty() && folds < 1.2 && are_small(mesh); }
};
Lids lids_of(const TriangleMesh& mesh);

/// The mesh with its lids: closed.
TriangleMesh closed_by(const Lids& lids, const TriangleMesh& mesh);

/// The distance to the nearest triangle, below 0 where the mesh winds around a point, x fastest; beyond `reach` mm it is that,
/// with its sign. Distances are exact but for rounding; the winding number is counted along lines in z, so the mesh must be
/// closed (self-intersections, overlaps and inverted parts may be: what is wound around any number of times but 0 is inside).
/// Bytes: 12 a point. Throws bad_input for a mesh that is not closed, or where the lattice does not reach beyond it, too_large,
/// cancelled.
std::vector<float> mesh_distances(const TriangleMesh& mesh, const DistanceLattice& lattice, double reach,
                                  Progress& progress = Progress::none());

}  // namespace fieldfab
