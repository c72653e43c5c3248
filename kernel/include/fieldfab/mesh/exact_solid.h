/// Boolean operations on polyhedral solids in exact arithmetic.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/polyhedron.h"

namespace fieldfab {

/// A Boolean operation.
enum class Operation { unite, intersect, subtract };

/// A polyhedral solid with exact vertices: operations lose no precision until polyhedron() rounds the vertices. Uses
/// CGAL's corefinement (Loriot et al., package Polygon Mesh Processing). Copies share their data.
class ExactSolid {
 public:
  ExactSolid() = default;  ///< the empty solid
  /// Reverses inward oriented faces. Throws Error(bad_input) unless the faces bound a solid.
  explicit ExactSolid(const Polyhedron& solid);

  [[nodiscard]] bool empty() const { return surface_ == nullptr; }
  /// whether the surface touches or crosses itself; such a solid cannot be combined
  [[nodiscard]] bool touches_itself() const;
  [[nodiscard]] Polyhedron polyhedron() const;  ///< vertices rounded to double precision
  /// Applies a linear map exactly. Precondition: the determinant is positive.
  [[nodiscard]] ExactSolid turned(const Eigen::Matrix3d& matrix) const;

  /// Combines two solids. Throws Error(bad_input) if the surface of one crosses or touches itself, or that of the
  /// result touches itself along an edge; Error(too_large) if so many faces are coplanar or cross that it would take
  /// long.
  friend ExactSolid combined(const ExactSolid& a, const ExactSolid& b, Operation operation);

 private:
  struct Surface;
  explicit ExactSolid(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {}
  std::shared_ptr<const Surface> surface_;
};

/// Combines several solids, in an order in which this is possible. Throws as combined(), and Error(cancelled).
ExactSolid all_of(std::vector<ExactSolid> solids, Operation operation, Progress& progress);

/// Returns the solid with a non-zero winding number of the mesh, exactly. Requires closed components that do not cross
/// themselves (they may cross each other), all oriented outward, or all inward, or inward ones within outward ones.
/// Returns std::nullopt for any other mesh, or if it would take long. Throws Error(cancelled).
std::optional<ExactSolid> exact_solid_of(const TriangleMesh& mesh, Progress& progress = Progress::none());

/// Rounds a surface to single precision, as files and TriangleMesh store it. Returns std::nullopt if the result does
/// not bound a solid, even without its slivers.
std::optional<TriangleMesh> in_single_precision(const Polyhedron& surface);

/// Whether a surface neither crosses nor touches itself. False if an edge has more than two faces.
bool is_simple(const Polyhedron& surface);

/// Whether the faces bound a solid: closed, oriented outward, free of self-intersections and of faces without area.
bool bounds_a_solid(const Polyhedron& surface);

}  // namespace fieldfab
