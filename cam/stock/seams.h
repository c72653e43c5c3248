/// Search of the edges of a stock's surface, cube by cube.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "cut_surfaces.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

/// Where an edge of the surface crosses a face of a cube: a point of the face between two vertices that the surface's
/// polygon in the face joins.
struct Seam {
  std::array<std::uint32_t, 2> ends;  ///< the vertices
  SurfacePiece::Place place;
  std::uint32_t cut;  ///< the later one of the two that meet there
};

/// A cube in which surfaces meet, with its triangles.
struct SharpCube {
  Index3 lower;             ///< its lower corner
  std::uint32_t triangles;  ///< their number
  /// Where three surfaces meet, if the cube has such a corner.
  bool has_corner;
  SurfacePiece::Place corner;
};

/// The sharp cubes of a surface, or of a part.
struct SharpCubes {
  std::vector<SharpCube> cubes;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of one cube after the other
  std::vector<Seam> seams;
};

/// Bits of what is known of a vertex: the axis of its edge, and whether the edge leads out of the material.
struct VertexState {
  static constexpr std::uint8_t axis_part = 3, not_level = 4, upwards = 8;
};

/// Directed edges around a part of a surface.
using Rim = std::vector<std::array<std::uint32_t, 2>>;
/// Sets `rim` to the edges that triangles do not share with each other, in the triangles' direction.
void find_rim(std::span<const std::array<std::uint32_t, 3>> triangles, Rim& rim);

/// Finds seams with the planes tangent to cuts at the vertices. Whether a pair of vertices has a seam between them
/// depends on these two only, so that the two cubes at a face agree.
class SeamFinder {
 public:
  SeamFinder(const SurfacePieces& pieces, const CutSurfaces& surfaces) : pieces_(pieces), surfaces_(surfaces) {}

  /// The sharp cubes of a piece. Vertices are named as in its `corners`. `state(owner, vertex)` returns the
  /// VertexState of the vertex of an edge.
  using State = std::function<std::uint8_t(std::size_t owner, std::uint32_t vertex)>;
  [[nodiscard]] SharpCubes find(std::size_t index, const State& state) const;

  /// Coordinate of the lattice's planes as vertices have it.
  static float plane(const StockLattice& lattice, std::size_t axis, int k) {
    const auto a = static_cast<int>(axis);
    return static_cast<float>(static_cast<double>(lattice.at(a, k)) + lattice.box().lower[a]);
  }

 private:
  class Search;

  const SurfacePieces& pieces_;
  const CutSurfaces& surfaces_;
};

}  // namespace fieldfab::cam
