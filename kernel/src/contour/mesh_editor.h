/// Changes of a mesh that keep it valid; each is checked with exact predicates first.
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
/// Each change replaces the triangles of a small patch by others with the same rim. It is made only
/// if no new triangle is degenerate, and each meets other triangles of the mesh in their common
/// vertex or edge only, by CGAL's exact predicates. So the mesh stays closed, 2-manifold and free
/// of self-intersections, whichever changes are tried, in any order.
class MeshEditor {
 public:
  /// `seeds` are the triangles that may change, together with their neighbours. They may grow by
  /// `reach` mm.
  MeshEditor(TriangleMesh& mesh, std::span<const std::uint32_t> seeds, double reach);

  /// Returns the triangles around a vertex; empty if the vertex is outside the opened region.
  [[nodiscard]] std::span<const std::uint32_t> fan(std::uint32_t vertex) const;
  /// Finds the two triangles at an edge, in no order. Returns false if the edge is outside the
  /// opened region.
  bool sides(std::uint32_t a, std::uint32_t b, std::array<std::uint32_t, 2>& triangles) const;

  /// Replaces the triangles `old` by `fresh`, which are at least as many. Vertices may have been
  /// moved, if all their triangles are in `old`, or appended to the mesh. Returns false, and
  /// changes no triangle, if the result would not be valid.
  bool replace(std::span<const std::uint32_t> old, std::span<const Triangle> fresh);

 private:
  [[nodiscard]] bool fits(const Triangle& triangle, std::span<const std::uint32_t> old);
  void enlist(std::uint32_t triangle);

  TriangleMesh& mesh_;
  double cell_;
  /// By cell, opened triangles only; stale entries stay.
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> triangles_in_;
  /// By vertex: index into fans_, or none.
  std::vector<std::uint32_t> fan_of_;
  std::vector<std::vector<std::uint32_t>> fans_;
  std::vector<std::uint32_t> near_;
};

}  // namespace fieldfab::contouring
