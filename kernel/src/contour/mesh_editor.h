/// Changes of a mesh that keep it valid; each is checked with exact predicates first.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cell_set.h"
#include "fieldfab/core/geometry.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

using Position = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// Bounds of triangles, which are exact in floats.
struct FloatBox {
  Position lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};

  void add(const Position& p) {
    for (std::size_t i = 0; i < 3; ++i) lower[i] = std::min(lower[i], p[i]), upper[i] = std::max(upper[i], p[i]);
  }
  [[nodiscard]] FloatBox grown(float by) const {
    FloatBox box = *this;
    for (std::size_t i = 0; i < 3; ++i) box.lower[i] -= by, box.upper[i] += by;
    return box;
  }
  [[nodiscard]] bool meets(const FloatBox& other) const {
    bool apart = false;  // without branches, since lists of boxes are searched
    for (std::size_t i = 0; i < 3; ++i) {
      apart |= upper[i] < other.lower[i];
      apart |= other.upper[i] < lower[i];
    }
    return !apart;
  }
};

/// A closed mesh without self-intersections, opened for small changes near some of its triangles.
///
/// Each change replaces the triangles of a small patch by others with the same rim. It is made only
/// if no new triangle is degenerate, and each meets other triangles of the mesh in their common
/// vertex or edge only, by CGAL's exact predicates. So the mesh stays closed, 2-manifold and free
/// of self-intersections, whichever changes are tried, in any order.
///
/// Changes in regions that have no cell in common may be made at the same time: a change reads and
/// writes triangles of its region, and reads those that cross its border, which no change may touch.
class MeshEditor {
 public:
  /// A block of cells. A change replaces triangles that lie in it by others that lie in it.
  struct Region {
    Cell lower, upper;  ///< the first cell, and the cell after the last one, along each axis
    /// Numbers for vertices and triangles that changes add.
    std::vector<std::uint32_t> spare_vertices, spare_triangles;
    std::vector<std::uint32_t> near;  ///< working memory
  };

  /// `seeds` are the triangles that may change, together with their neighbours. They may grow by
  /// `reach` mm. Cells are cubes of `cell` mm.
  MeshEditor(TriangleMesh& mesh, std::span<const std::uint32_t> seeds, double cell, double reach);

  [[nodiscard]] Cell cell_of(const Position& point) const;
  [[nodiscard]] bool holds(const Region& region, std::uint32_t vertex) const;
  /// Whether a vertex and all triangles in fan() lie in a region.
  [[nodiscard]] bool holds_fan(const Region& region, std::uint32_t vertex) const;
  [[nodiscard]] Box extent(const Region& region) const;
  /// Returns the region of all cells.
  static Region everything();

  /// Adds numbers for `count` vertices to a region, and for the triangles that they bring. Not
  /// while changes are made.
  void supply(Region& region, std::size_t count);
  /// Takes back the numbers that a region has not used. Not while changes are made.
  void take_back(Region& region);
  /// Removes the numbers that no change has used from the mesh; no further changes can be made.
  void finish();

  /// Returns the triangles around a vertex; empty if the vertex is outside the opened part.
  [[nodiscard]] std::span<const std::uint32_t> fan(std::uint32_t vertex) const;
  /// Finds the two triangles at an edge, in no order. Returns false if the edge is outside the
  /// opened part.
  bool sides(std::uint32_t a, std::uint32_t b, std::array<std::uint32_t, 2>& triangles) const;

  /// A vertex that was moved, and its position before.
  struct Displaced {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t vertex = none;
    Position position{};
  };

  /// Replaces the triangles `old` of a region by `fresh`, which are at least as many; the further
  /// ones get spare numbers. One vertex may have been moved, if all its triangles are in `old`; fresh
  /// triangles may have spare vertices. Appends the numbers of the fresh triangles to `changed`.
  /// Returns false, and changes no triangle, if the result would not be valid or would leave the
  /// region.
  bool replace(Region& region, std::span<const std::uint32_t> old, std::span<const Triangle> fresh, Displaced displaced,
               std::vector<std::uint32_t>& changed);

 private:
  static constexpr std::size_t triangles_a_part = 4096;
  [[nodiscard]] std::size_t parts() const { return (mesh_.triangles.size() + triangles_a_part - 1) / triangles_a_part; }
  template <class Visit>
  void for_triangles(const Visit& visit) const;
  template <class Visit>
  bool for_cells(const FloatBox& box, const Visit& visit) const;
  template <class IsOpen>
  void open_cells(const IsOpen& is_open, float reach);
  template <class IsOpen>
  void list_triangles(const IsOpen& is_open);
  [[nodiscard]] bool fits(Region& region, const Triangle& triangle, std::span<const std::uint32_t> old) const;
  /// A triangle in a cell, and its bounds: searches leave most triangles of a cell at these.
  struct Listed {
    FloatBox box;
    std::uint32_t triangle;
  };
  void enlist(std::uint32_t triangle);
  void strike(std::uint32_t triangle);

  TriangleMesh& mesh_;
  double cell_;
  CellSet opened_;
  std::vector<std::vector<Listed>> triangles_in_;  ///< by opened cell
  /// By vertex: index into fans_, or none.
  std::vector<std::uint32_t> fan_of_;
  std::vector<std::vector<std::uint32_t>> fans_;
  std::vector<std::uint32_t> spare_vertices_, spare_triangles_;
};

}  // namespace fieldfab::contouring
