/// Isosurface extraction in bricks: cubes of a lattice whose meshes, each made from the Field around it only, join to
/// the mesh of contour().
#pragma once

#include <array>

#include "fieldfab/contour/contour.h"

namespace fieldfab {

/// Triangles of contour() in a brick.
struct BrickMesh : TriangleMesh {
  /// Indices of the vertices on the sides of the brick, ascending. The meshes of neighbours have them too, with equal
  /// coordinates, to the bit.
  std::vector<std::uint32_t> seam;
};

/// Division of the lattice of contour() into bricks. Each triangle belongs to one brick, so that the triangles of all
/// bricks are those of contour(), and close where their seams are joined.
class ContourBricks {
 public:
  /// Edge of a brick, in cells.
  static constexpr int usual_cells = 256;

  /// Divides the cells of contour(field, bounds, settings) for any Field that is sampled() without sampling(), such as
  /// an Asdf. `cells`: edge of a brick, in cells, a power of two of at least 32. Throws Error(bad_input).
  ContourBricks(const Box& bounds, const ContourSettings& settings, int cells = usual_cells);

  /// Number of bricks along each axis.
  [[nodiscard]] const std::array<int, 3>& count() const { return count_; }
  /// Returns the box that the mesh of a brick depends on, mm: a Field that equals the solid there, and has its
  /// known_bounds(), gives the same mesh. Throws Error(bad_input) if there is no such brick.
  [[nodiscard]] Box surroundings(const std::array<int, 3>& brick) const;
  /// Returns the mesh of a brick. Throws Error(bad_input) if there is no such brick, or unless `field` is sampled()
  /// without sampling(); Error(too_large), Error(cancelled).
  [[nodiscard]] BrickMesh mesh(const Field& field, const std::array<int, 3>& brick,
                               Progress& progress = Progress::none()) const;

 private:
  Box bounds_;
  ContourSettings settings_;
  int cells_;
  std::array<int, 3> count_;
};

}  // namespace fieldfab
