/// Solids with flat faces in exact arithmetic, and what two of them make.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/polyhedron.h"

namespace fieldfab {

enum class Operation { unite, intersect, subtract };

/// A solid whose corners are exact: what cuts make of it loses nothing, until it is asked for its corners. By CGAL, with the
/// corefinement of Loriot et al. (its package Polygon Mesh Processing).
class ExactSolid {
 public:
  ExactSolid() = default;  ///< nothing
  /// Faces that wind the wrong way are turned. Throws bad_input where they are not the surface of a solid.
  explicit ExactSolid(const Polyhedron& solid);

  [[nodiscard]] bool empty() const { return surface_ == nullptr; }
  [[nodiscard]] bool touches_itself() const;    ///< or crosses itself: it cannot be joined with others
  [[nodiscard]] Polyhedron polyhedron() const;  ///< corners rounded to double precision
  /// Exactly; by a matrix that does not mirror.
  [[nodiscard]] ExactSolid turned(const Eigen::Matrix3d& matrix) const;

  /// Throws bad_input where the surface of one crosses or touches itself, or where the result's touches itself along an edge;
  /// too_large where so many faces lie in planes of the other's faces, or cross them, that it would take long.
  friend ExactSolid combined(const ExactSolid& a, const ExactSolid& b, Operation operation);

 private:
  struct Surface;
  explicit ExactSolid(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {}
  std::shared_ptr<const Surface> surface_;
};

/// What many make together, joined in an order in which they can be. Throws as combined() does, and cancelled.
ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress);

/// What a mesh winds around, where that can be had exactly: its pieces are closed, do not cross themselves (each other they may),
/// and face outward, or all inward, or inward within those that face outward. Nothing where it is not so, or takes long. Throws
/// cancelled.
std::optional<ExactSolid> exact_solid_of(const TriangleMesh& mesh, Progress& progress = Progress::none());

/// The surface in single precision, as files and TriangleMesh have it; nothing where that is no longer the surface of a solid,
/// also not without its slivers.
std::optional<TriangleMesh> in_single_precision(const Polyhedron& surface);

/// Whether a surface neither crosses nor touches itself. False, too, where an edge has more than two faces.
bool is_simple(const Polyhedron& surface);

/// Whether it is the surface of a solid: closed, facing out, not crossing itself, without faces that have no area.
bool bounds_a_solid(const Polyhedron& surface);

}  // namespace fieldfab
