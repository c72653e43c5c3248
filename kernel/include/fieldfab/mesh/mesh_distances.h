/// Signed distances to a mesh at all points of a lattice; for many points hundreds of times faster than mesh_field().
#pragma once

#include <array>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// The lattice of points origin + spacing * (i, j, k).
struct DistanceLattice {
  Vec3 origin = Vec3::Zero();
  double spacing = 1;         ///< mm
  std::array<int, 3> size{};  ///< number of points along x, y and z, each at least 2
  /// Number of points.
  [[nodiscard]] double points() const { return 1.0 * size[0] * size[1] * size[2]; }
};

/// Triangles that close a mesh. They cover each edge that has unequal numbers of triangles in its two directions. A
/// boundary that is a single loop is triangulated between its own vertices; others, and very long ones, are joined to
/// their centre. Empty for a closed mesh. Indices refer to the vertices of the mesh, then to `middles`. Vertices at
/// equal positions count as different; read_mesh() has merged them.
struct Lids {
  std::size_t rims = 0, edges = 0;  ///< number of boundaries, and of their edges
  std::vector<std::array<float, 3>> middles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double area = 0;  ///< mm2
  /// greatest ratio of a lid's area to that of its planar projection; above 1 it folds over itself
  double folds = 1;

  /// Whether the lids close holes. For an isolated piece of a surface the lids duplicate the piece with opposite
  /// orientation.
  [[nodiscard]] bool are_small(const TriangleMesh& mesh) const { return area <= 0.5 * mesh.area(); }
  /// Whether there are lids, and they are as good as the mesh: small, and none folds over itself.
  [[nodiscard]] bool are_good(const TriangleMesh& mesh) const {
    return !triangles.empty() && folds < 1.2 && are_small(mesh);
  }
};
/// Returns the lids of a mesh.
Lids lids_of(const TriangleMesh& mesh);

/// Returns the mesh with its lids: a closed mesh.
TriangleMesh closed_by(const Lids& lids, const TriangleMesh& mesh);

/// Returns the signed distance to the nearest triangle at each point, mm, x fastest; negative if the winding number of
/// the mesh is not 0. Values are clamped to +-`reach` mm and otherwise exact up to rounding. The winding number is
/// counted along lines parallel to z, so that the mesh must be closed; self-intersections, overlaps and inverted
/// components are permitted. Memory: 12 bytes per point. Throws Error(bad_input) for a mesh that is not closed or
/// extends beyond the lattice, Error(too_large), Error(cancelled).
std::vector<float> mesh_distances(const TriangleMesh& mesh, const DistanceLattice& lattice, double reach,
                                  Progress& progress = Progress::none());

}  // namespace fieldfab
