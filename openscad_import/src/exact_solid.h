/// Solids with flat faces in exact arithmetic, and what two of them make.
#pragma once

#include <memory>

#include "polyhedron.h"

namespace fieldfab::openscad {

enum class Operation { unite, intersect, subtract };

/// A solid whose corners are exact: what cuts make of it loses nothing, until it is asked for its corners. By CGAL, with the
/// corefinement of Loriot et al. (its package Polygon Mesh Processing).
class ExactSolid {
 public:
  ExactSolid() = default;  ///< nothing
  /// Faces that wind the wrong way are turned. Throws bad_input where they are not the surface of a solid.
  explicit ExactSolid(const Polyhedron& solid);

  [[nodiscard]] bool empty() const { return surface_ == nullptr; }
  [[nodiscard]] Polyhedron polyhedron() const;  ///< corners rounded to double precision

  /// Throws bad_input where the surface of one crosses itself, or where the result's touches itself along an edge; too_large
  /// where so many faces lie in planes of the other's faces, or cross them, that it would take long.
  friend ExactSolid combined(const ExactSolid& a, const ExactSolid& b, Operation operation);

 private:
  struct Surface;
  explicit ExactSolid(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {}
  std::shared_ptr<const Surface> surface_;
};

/// What many make together. Throws as combined() does, and cancelled.
ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress);

/// A surface without edges shorter than `narrowest` mm, and without triangles narrower than that: corners are joined and edges
/// turned as far as the surface stays one.
Polyhedron without_slivers(const Polyhedron& surface, double narrowest);

/// Whether it is the surface of a solid: closed, facing out, not crossing itself, without faces that have no area.
bool bounds_a_solid(const Polyhedron& surface);

}  // namespace fieldfab::openscad
