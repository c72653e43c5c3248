/// Changes to a mesh that keep it valid: nothing is changed but after a check with exact predicates.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

using Position = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// A closed mesh without self-intersections, opened for small changes near some of its triangles.
///
/// Every change replaces the triangles of a small patch by others with the same rim. It is made only if each new triangle is not
/// degenerate and meets no other triangle of the mesh but in their common vertex or edge, as CGAL's exact predicates say. So the
/// mesh stays closed, 2-manifold and free of self-intersections, whatever is tried, in any order.
class MeshEditor {
 public:
  /// `seeds`: the triangles that may change, with those next to them, and may grow by `reach` mm.
  MeshEditor(TriangleMesh& mesh, std::span<const std::uint32_t> seeds, double reach);

  /// The triangles around a vertex; empty where the vertex is outside of the region opened.
  [[nodiscard]] std::span<const std::uint32_t> fan(std::uint32_t vertex) const;
  /// The two triangles at an edge (in no order); false where the edge is outside of the region opened.
  bool sides(std::uint32_t a, std::uint32_t b, std::array<std::uint32_t, 2>& triangles) const;

  /// Replaces the triangles `old` by `fresh`, at least as many. Vertices may have been moved (all their triangles are then in
  /// `old`) or appended to the mesh. False, and no triangle changed, where that would not be valid.
  bool replace(std::span<const std::uint32_t> old, std::span<const Triangle> fresh);

 private:
  [[nodiscard]] bool fits(const Triangle& triangle, std::span<const std::uint32_t> old);
  void enlist(std::uint32_t triangle);

  TriangleMesh& mesh_;
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> triangles_in_;  ///< by cell, opened ones only; stale entries stay
  std::vector<std::uint32_t> fan_of_;                                           ///< by vertex: index among fans_, or none
  std::vector<std::vector<std::uint32_t>> fans_;
  std::vector<std::uint32_t> near_;
};

}  // namespace fieldfab::contouring
