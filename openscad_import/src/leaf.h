/// Solids of a design, and their Boolean combinations.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"
#include "polygon_field.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// A leaf or a part: a formula if it has one, otherwise a Field; neither if it is empty.
struct Shape {
  std::optional<frep::Expression> formula;
  FieldPtr field = nullptr;
  Box box = {};  ///< contains the shape
  /// Outside the box the value is at least this factor times the distance to it along the farthest
  /// axis.
  double steepness = 1;

  [[nodiscard]] bool empty() const { return !formula && !field; }
  [[nodiscard]] FieldPtr as_field() const;
};

/// Conversion of leafs to Fields.
struct Making {
  /// Growth of each solid, mm. Solids that touch must become one solid, but a Field is 0, and so
  /// not inside, on common faces. The growth is negligible, and exceeds the rounding of single
  /// precision.
  double growth = 0;
  double step = 0;             ///< additional growth of subtracted solids, so that no skin remains on common faces
  bool formulas_only = false;  ///< throw bad_input for a shape without a formula
  Progress* progress = &Progress::none();
};

/// A primitive solid at its place in the design.
class Leaf {
 public:
  virtual ~Leaf() = default;
  [[nodiscard]] virtual Shape solid(const Making& making) const = 0;
  /// Returns flat faces: as OpenSCAD draws the leaf, or a fine approximation if it is round.
  [[nodiscard]] virtual Polyhedron polyhedron() const = 0;
  /// Whether polyhedron() equals the leaf and is the surface of a solid.
  [[nodiscard]] virtual bool has_flat_faces() const { return true; }
  [[nodiscard]] virtual Box bounds() const = 0;
  /// Approximate smallest thickness, mm: to choose cells that resolve it.
  [[nodiscard]] virtual double thickness() const = 0;
  /// See Shape.
  [[nodiscard]] virtual double steepness() const { return 1; }
  /// Area of its surface, mm^2.
  [[nodiscard]] double area() const { return to_mesh(polyhedron()).area(); }
  [[nodiscard]] virtual bool convex() const { return false; }
  /// An exact ball.
  struct BallShape {
    Vec3 centre;
    double radius;
  };
  [[nodiscard]] virtual std::optional<BallShape> ball() const { return std::nullopt; }
};
using LeafPtr = std::shared_ptr<const Leaf>;

/// Makes a leaf of a convex polyhedron.
LeafPtr convex_leaf(Polyhedron solid);
/// Makes a leaf of any polyhedron; of a convex one a convex_leaf(). Null if it is empty.
LeafPtr mesh_leaf(Polyhedron solid);
/// Makes a leaf of the points within `radius` mm of a polyhedron.
LeafPtr rounded_leaf(Polyhedron solid, double radius);
/// Extrudes a flat shape from z = lower to z = upper, then places it.
LeafPtr extruded_leaf(const Region& region, double lower, double upper, const Eigen::Affine3d& placement);
/// A profile in x >= 0, whose y is z, rotated about z and then placed. A full turn closes itself.
struct TurnedShape {
  Region profile;
  Turn turn;
  double total = 0;  ///< radians, signed
  bool full = true;
};
LeafPtr turned_leaf(TurnedShape shape, const Eigen::Affine3d& placement);
/// Makes a leaf of a convex solid of revolution: its placed polyhedron, and its profile with the
/// placement.
LeafPtr faceted_leaf(Polyhedron solid, TurnedShape shape, const Eigen::Affine3d& placement);
/// A round cylinder or cone about z, then placed.
struct RoundCone {
  double r1, r2, lower, upper;
};
LeafPtr cone_leaf(const RoundCone& cone, const Eigen::Affine3d& placement);
/// A ball around the origin, then placed.
LeafPtr ball_leaf(double radius, const Eigen::Affine3d& placement);

/// A node of the tree of Boolean operations.
struct Part {
  enum class Kind { nothing, leaf, unite, intersect, subtract };
  Kind kind = Kind::nothing;
  LeafPtr leaf = nullptr;
  std::vector<std::shared_ptr<const Part>> children = {};

  [[nodiscard]] bool empty() const { return kind == Kind::nothing; }
};
using PartPtr = std::shared_ptr<const Part>;

PartPtr nothing();
PartPtr part_of(LeafPtr leaf);  ///< nothing() if the leaf is null
/// Boolean operations; empty parts are dropped.
PartPtr unite(std::vector<PartPtr> parts);
PartPtr intersect(std::vector<PartPtr> parts);
PartPtr subtract(std::vector<PartPtr> parts);

/// A box that contains the part. Precondition: the part is not empty.
Box bounds_of(const Part& part);
/// Minimum of thickness() over its leafs.
double thickness_of(const Part& part);
/// Sum of the surface areas of its leafs, mm^2.
double area_of(const Part& part);
Shape solid_of(const Part& part, const Making& making);
/// Returns the exact polyhedron of a part.
Polyhedron polyhedron_of(const Part& part, Progress& progress);
/// Returns solids whose union is the part; `all_convex` is set to whether all of them are convex.
std::vector<Polyhedron> pieces_of(const Part& part, bool& all_convex, Progress& progress);
/// Returns the surface of a part whose leafs all have flat faces, with the vertices and edges of
/// exact arithmetic, rounded to single precision once. Returns nullopt if a leaf is round or not a
/// solid, if no surface with rounded vertices is valid, or if it would take long; such a part is
/// contoured. Solids that touch along an edge, or that have very many faces in common planes, are
/// first grown by a few millionths of the farthest coordinate, each by a different amount. Throws
/// cancelled.
std::optional<TriangleMesh> faces_of(const Part& part, Progress& progress);
/// Cross-section of the part at z = 0.
Region slice_of(const Part& part, Progress& progress);

}  // namespace fieldfab::openscad
