/// The solids a design is made of, and how they are joined.
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

/// A leaf or a part: a formula where it can be one, else a Field; neither where it is empty.
struct Shape {
  std::optional<frep::Expression> formula;
  FieldPtr field = nullptr;
  Box box = {};          ///< holds it
  double steepness = 1;  ///< outside of the box the value is at least so many times the distance to it along the farthest axis

  [[nodiscard]] bool empty() const { return !formula && !field; }
  [[nodiscard]] FieldPtr as_field() const;
};

/// How leafs become Fields.
struct Making {
  /// Solids that touch are one solid, though a Field is 0, and so not inside, where their faces meet. So each is grown by so many
  /// mm: much less than matters, and more than single precision loses.
  double growth = 0;
  double step = 0;             ///< so much more for what is taken away, so that no skin stays where faces meet
  bool formulas_only = false;  ///< throw bad_input rather than give what has no formula
  Progress* progress = &Progress::none();
};

/// A solid without parts, where it stands in the design.
class Leaf {
 public:
  virtual ~Leaf() = default;
  [[nodiscard]] virtual Shape solid(const Making& making) const = 0;
  /// With flat faces: as OpenSCAD draws it, or finely where it is round.
  [[nodiscard]] virtual Polyhedron polyhedron() const = 0;
  /// Whether polyhedron() is the leaf itself, and the surface of a solid.
  [[nodiscard]] virtual bool has_flat_faces() const { return true; }
  [[nodiscard]] virtual Box bounds() const = 0;
  /// About how thin it is where it is thinnest, mm: for choosing cells that do not miss it.
  [[nodiscard]] virtual double thickness() const = 0;
  /// See Shape.
  [[nodiscard]] virtual double steepness() const { return 1; }
  /// Of its surface, mm^2.
  [[nodiscard]] double area() const { return to_mesh(polyhedron()).area(); }
  [[nodiscard]] virtual bool convex() const { return false; }
  /// Where it is a true ball.
  struct BallShape {
    Vec3 centre;
    double radius;
  };
  [[nodiscard]] virtual std::optional<BallShape> ball() const { return std::nullopt; }
};
using LeafPtr = std::shared_ptr<const Leaf>;

/// Anything convex with flat faces.
LeafPtr convex_leaf(Polyhedron solid);
/// Anything with flat faces; a convex one becomes a convex_leaf(). Null where it is empty.
LeafPtr mesh_leaf(Polyhedron solid);
/// What is within `radius` mm of a solid with flat faces.
LeafPtr rounded_leaf(Polyhedron solid, double radius);
/// A flat shape from z = lower to upper, then placed.
LeafPtr extruded_leaf(const Region& region, double lower, double upper, const Eigen::Affine3d& placement);
/// A profile in x >= 0 (its y being z) turned about z, then placed. `full` turns close themselves.
struct TurnedShape {
  Region profile;
  Turn turn;
  double total = 0;  ///< radians, with its sign
  bool full = true;
};
LeafPtr turned_leaf(TurnedShape shape, const Eigen::Affine3d& placement);
/// What is convex and turned about an axis: its corners where it stands, and the same by its profile and placement.
LeafPtr faceted_leaf(Polyhedron solid, TurnedShape shape, const Eigen::Affine3d& placement);
/// A true cylinder or cone about z, then placed.
struct RoundCone {
  double r1, r2, lower, upper;
};
LeafPtr cone_leaf(const RoundCone& cone, const Eigen::Affine3d& placement);
/// A true ball about the origin, then placed.
LeafPtr ball_leaf(double radius, const Eigen::Affine3d& placement);

/// What is joined to a design: a tree.
struct Part {
  enum class Kind { nothing, leaf, unite, intersect, subtract };
  Kind kind = Kind::nothing;
  LeafPtr leaf = nullptr;
  std::vector<std::shared_ptr<const Part>> children = {};

  [[nodiscard]] bool empty() const { return kind == Kind::nothing; }
};
using PartPtr = std::shared_ptr<const Part>;

PartPtr nothing();
PartPtr part_of(LeafPtr leaf);  ///< nothing where it is null
/// These drop what is empty.
PartPtr unite(std::vector<PartPtr> parts);
PartPtr intersect(std::vector<PartPtr> parts);
PartPtr subtract(std::vector<PartPtr> parts);

/// A box that holds it; only for one that is not empty.
Box bounds_of(const Part& part);
/// The least thickness() of its leafs.
double thickness_of(const Part& part);
/// The sum of the areas of its leafs' surfaces, mm^2.
double area_of(const Part& part);
Shape solid_of(const Part& part, const Making& making);
/// With flat faces, exactly, whatever it is joined from.
Polyhedron polyhedron_of(const Part& part, Progress& progress);
/// Solids whose union is the part: convex where `all_convex` is told so.
std::vector<Polyhedron> pieces_of(const Part& part, bool& all_convex, Progress& progress);
/// The surface of a part whose leafs have flat faces only, with the corners and edges that exact arithmetic gives, rounded to
/// single precision once. Nothing where a leaf is round, or is not a solid; where no surface with rounded corners is valid; or
/// where it would take long: such a part is contoured. Solids that touch along an edge, or have very many faces in common planes,
/// are first grown by a few millionths of the farthest coordinate, each by another amount. Throws cancelled.
std::optional<TriangleMesh> faces_of(const Part& part, Progress& progress);
/// Where the plane z = 0 cuts it.
Region slice_of(const Part& part, Progress& progress);

}  // namespace fieldfab::openscad
