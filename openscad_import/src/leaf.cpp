#include "leaf.h"

#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/linear_maps.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/mesh/exact_solid.h"
#include "fieldfab/mesh/mesh_field.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

using frep::Expression;

constexpr std::size_t most_planes_of_turned = 40;  // with more, solids of revolution are evaluated by their profile

/// Returns a x + b y + c z + d without terms that are 0.
Expression linear(const Vec3& slope, double shift) {
  const std::array<Expression, 3> axis{Expression::x(), Expression::y(), Expression::z()};
  Expression sum(0.0);
  for (int i = 0; i < 3; ++i)
    if (std::abs(slope[i]) > 1e-12) sum = sum + axis[static_cast<std::size_t>(i)] * slope[i];
  return sum + shift;
}

/// Joins all expressions in a tree of minimal depth.
template <class Join>
Expression joined(std::vector<Expression> all, const Join& join) {
  while (all.size() > 1) {
    std::vector<Expression> half;
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) half.push_back(join(all[i], all[i + 1]));
    if (all.size() % 2 == 1) half.push_back(all.back());
    all = std::move(half);
  }
  return all.front();
}

Expression formula_of(const std::vector<Plane>& planes, double growth) {
  std::vector<Expression> all;
  for (const Plane& plane : planes) all.push_back(linear(plane.normal, -plane.offset - growth));
  return joined(std::move(all), [](const Expression& a, const Expression& b) { return max(a, b); });
}

[[noreturn]] void no_formula(const char* what) {
  throw Error(ErrorKind::bad_input, what,
              "has no formula: only Booleans of primitives, hulls and straight extrusions do");
}

class Convex final : public Leaf {
 public:
  explicit Convex(Polyhedron solid) : solid_(std::move(solid)), planes_(planes_of(solid_)) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    // With the sides of its bounding box the value is never less than the distance to that box.
    std::vector<Plane> planes = planes_;
    const Box box = solid_.bounds();
    for (int axis = 0; axis < 3 && !making.formulas_only; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        const Vec3 normal = sign * Vec3::Unit(axis);
        if (std::none_of(planes_.begin(), planes_.end(),
                         [&](const Plane& plane) { return plane.normal.dot(normal) > 1 - 1e-12; }))
          planes.push_back({normal, sign > 0 ? box.upper[axis] : -box.lower[axis]});
      }
    return {formula_of(planes, making.growth)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override { return solid_; }
  [[nodiscard]] Box bounds() const override { return solid_.bounds(); }
  [[nodiscard]] double thickness() const override {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t every = 1 + planes_.size() / 64;  // a sample of many planes suffices
    for (std::size_t i = 0; i < planes_.size(); i += every) {
      double farthest = 0;
      for (const Vec3& p : solid_.vertices) farthest = std::max(farthest, planes_[i].offset - planes_[i].normal.dot(p));
      least = std::min(least, farthest);
    }
    return least;
  }
  [[nodiscard]] bool convex() const override { return true; }
  [[nodiscard]] std::size_t count() const { return planes_.size(); }

 private:
  Polyhedron solid_;
  std::vector<Plane> planes_;
};

class Mesh final : public Leaf {
 public:
  Mesh(Polyhedron solid, double radius) : solid_(std::move(solid)), radius_(radius) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    if (making.formulas_only) no_formula("a polyhedron that is not convex");
    constexpr std::size_t many = 500'000;  // triangles: a search for self-intersections would take too long
    if (solid_.triangles.size() < many && bounds_a_solid(solid_))
      return {std::nullopt, surface_field(solid_, radius_ + making.growth)};
    return {std::nullopt, offset(mesh_field(to_mesh(solid_), *making.progress), radius_ + making.growth)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override { return solid_; }
  [[nodiscard]] bool has_flat_faces() const override { return radius_ == 0 && bounds_a_solid(solid_); }
  [[nodiscard]] Box bounds() const override { return solid_.bounds().grown(radius_); }
  [[nodiscard]] double thickness() const override {
    const TriangleMesh mesh = to_mesh(solid_);
    return 2 * std::abs(mesh.volume()) / mesh.area() + 2 * radius_;
  }

 private:
  Polyhedron solid_;
  double radius_;
};

/// Applies a placement to a Field; values remain lower bounds of the distance.
FieldPtr placed(const FieldPtr& field, const Eigen::Affine3d& placement) {
  if (placement.isApprox(Eigen::Affine3d::Identity(), 0)) return field;
  const double least = stretch_of(placement.linear()).least;
  const FieldPtr there = transform(field, placement);
  return std::abs(least - 1) < 1e-5 ? there : scaled_values(there, least);
}

Expression placed(const Expression& formula, const Eigen::Affine3d& placement) {
  const Eigen::Affine3d back = placement.inverse();
  const double least = stretch_of(placement.linear()).least;
  const auto row = [&](int i) { return linear(back.linear().row(i).transpose(), back.translation()[i]); };
  const Expression there = remap(formula, row(0), row(1), row(2));
  return std::abs(least - 1) < 1e-5 ? there : there * least;
}

class ExtrudedLeaf final : public Leaf {
 public:
  ExtrudedLeaf(Region region, double lower, double upper, const Eigen::Affine3d& placement)
      : region_(std::move(region)), lower_(lower), upper_(upper), placement_(placement) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    const double growth = making.growth / stretch_of(placement_.linear()).least;
    if (making.formulas_only) return {placed(formula(growth), placement_)};
    return {std::nullopt, placed(extruded_field(region_, lower_, upper_, growth), placement_)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override {
    return moved(
        sweep(region_, 1, [&](const Vec2& p, int step) { return Vec3(p.x(), p.y(), step == 0 ? lower_ : upper_); }),
        placement_);
  }
  [[nodiscard]] Box bounds() const override {
    const Eigen::AlignedBox2d flat = region_.bounds();
    return image_of({{flat.min().x(), flat.min().y(), lower_}, {flat.max().x(), flat.max().y(), upper_}},
                    placement_.linear(), placement_.translation());
  }
  [[nodiscard]] double steepness() const override {
    const Stretch stretch = stretch_of(placement_.linear());
    return stretch.least / stretch.greatest;
  }
  [[nodiscard]] double thickness() const override {
    return std::min(upper_ - lower_, region_.stroke()) * stretch_of(placement_.linear()).least;
  }

 private:
  [[nodiscard]] Expression formula(double growth) const {
    // Outer outlines minus holes. Holes lie inside, so the order matters only if a piece lies in a
    // hole.
    std::vector<Expression> solid, holes;
    for (const Outline& outline : region_.outlines) {
      std::vector<double> numbers;
      double twice = 0;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
        numbers.push_back(p.x()), numbers.push_back(p.y());
        twice += p.x() * q.y() - p.y() * q.x();
      }
      (twice > 0 ? solid : holes).push_back(frep::shapes::outline(numbers));
    }
    const auto least = [](const Expression& a, const Expression& b) { return min(a, b); };
    // A piece lies in a hole: each outer outline loses only the holes inside it.
    std::vector<Expression> pieces;
    std::size_t hole = 0;
    std::vector<std::vector<Expression>> taken(solid.size());
    std::vector<const Outline*> outer;
    for (const Outline& outline : region_.outlines)
      if (Region{{outline}}.area() > 0) outer.push_back(&outline);
    for (const Outline& outline : region_.outlines) {
      if (Region{{outline}}.area() > 0) continue;
      std::size_t best = 0;
      double least_area = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < outer.size(); ++i) {
        const Region around{{*outer[i]}};
        if (around.area() < least_area &&
            intersect({around, wound({outline})}).area() > 0.5 * -Region{{outline}}.area())
          best = i, least_area = around.area();
      }
      taken[best].push_back(holes[hole++]);
    }
    for (std::size_t i = 0; i < solid.size(); ++i)
      pieces.push_back(taken[i].empty() ? solid[i] : max(solid[i], -joined(taken[i], least)));
    const Expression flat = joined(std::move(pieces), least);
    const Expression z = Expression::z();
    return max(flat, max(lower_ - z, z - upper_)) - growth;
  }

  Region region_;
  double lower_, upper_;
  Eigen::Affine3d placement_;
};

class TurnedLeaf final : public Leaf {
 public:
  TurnedLeaf(TurnedShape shape, const Eigen::Affine3d& placement) : shape_(std::move(shape)), placement_(placement) {}

  [[nodiscard]] Shape solid(const Making& making) const override {
    const double growth = making.growth / stretch_of(placement_.linear()).least;
    if (making.formulas_only) no_formula("rotate_extrude");
    // Both halves of the profile, so that the axis is not part of its boundary.
    Eigen::Affine2d mirror = Eigen::Affine2d::Identity();
    mirror(0, 0) = -1;
    const Region whole = unite({shape_.profile, moved(shape_.profile, mirror)});
    FieldPtr field = turned_field(whole, shape_.turn, growth);
    if (!shape_.full) field = fieldfab::intersect(field, wedge(growth));
    return {std::nullopt, placed(field, placement_)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override {
    constexpr int fine = 180;
    const bool round = shape_.turn.fragments == 0;
    const int steps =
        round ? std::max(1, static_cast<int>(std::ceil(fine * std::abs(shape_.total) / (2 * std::numbers::pi))))
              : shape_.turn.fragments;
    return moved(turned(shape_.profile, shape_.turn.first, shape_.total / steps, steps, shape_.full), placement_);
  }
  [[nodiscard]] bool has_flat_faces() const override { return shape_.turn.fragments > 0; }
  [[nodiscard]] Box bounds() const override {
    const Eigen::AlignedBox2d flat = shape_.profile.bounds();
    const double r = flat.max().x();
    return image_of({{-r, -r, flat.min().y()}, {r, r, flat.max().y()}}, placement_.linear(), placement_.translation());
  }
  [[nodiscard]] double steepness() const override {
    const Stretch stretch = stretch_of(placement_.linear());
    return (shape_.turn.fragments > 0 ? std::cos(shape_.turn.step / 2) : 1) * stretch.least / stretch.greatest;
  }
  [[nodiscard]] double thickness() const override {
    return shape_.profile.stroke() * stretch_of(placement_.linear()).least;
  }

 private:
  /// The wedge between the ends of a partial turn.
  [[nodiscard]] FieldPtr wedge(double growth) const {
    const double from = std::min(shape_.turn.first, shape_.turn.first + shape_.total), angle = std::abs(shape_.total);
    const auto left_of = [&](double way) { return linear({std::sin(way), -std::cos(way), 0}, 0); };
    const Expression first = left_of(from), last = -left_of(from + angle);
    return frep::make_field((angle <= std::numbers::pi ? max(first, last) : min(first, last)) - growth);
  }

  TurnedShape shape_;
  Eigen::Affine3d placement_;
};

/// A convex solid of revolution: by its planes if they are few.
class Faceted final : public Leaf {
 public:
  Faceted(Polyhedron solid, TurnedShape shape, const Eigen::Affine3d& placement)
      : planes_(std::move(solid)), turned_(std::move(shape), placement) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    return making.formulas_only || planes_.count() <= most_planes_of_turned ? planes_.solid(making)
                                                                            : turned_.solid(making);
  }
  [[nodiscard]] Polyhedron polyhedron() const override { return planes_.polyhedron(); }
  [[nodiscard]] Box bounds() const override { return planes_.bounds(); }
  [[nodiscard]] double steepness() const override { return std::min(planes_.steepness(), turned_.steepness()); }
  [[nodiscard]] double thickness() const override { return planes_.thickness(); }
  [[nodiscard]] bool convex() const override { return true; }

 private:
  Convex planes_;
  TurnedLeaf turned_;
};

class Cone final : public Leaf {
 public:
  Cone(const RoundCone& cone, const Eigen::Affine3d& placement) : cone_(cone), placement_(placement) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    const auto& [r1, r2, lower, upper] = cone_;
    const double height = upper - lower, slant = std::hypot(height, r2 - r1);
    const Expression z = Expression::z(), r = sqrt(square(Expression::x()) + square(Expression::y()));
    const Expression side = ((r - r1) * height - (z - lower) * (r2 - r1)) / slant;
    return {placed(max(side, max(lower - z, z - upper)) - making.growth / stretch_of(placement_.linear()).least,
                   placement_)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override {
    constexpr int fine = 180;
    Outline profile{{0, cone_.lower}, {cone_.r1, cone_.lower}, {cone_.r2, cone_.upper}, {0, cone_.upper}};
    return moved(turned({{profile}}, 0, 2 * std::numbers::pi / fine, fine, true), placement_);
  }
  [[nodiscard]] bool has_flat_faces() const override { return false; }
  [[nodiscard]] Box bounds() const override {
    const double r = std::max(cone_.r1, cone_.r2);
    return image_of({{-r, -r, cone_.lower}, {r, r, cone_.upper}}, placement_.linear(), placement_.translation());
  }
  [[nodiscard]] double steepness() const override {
    const Stretch stretch = stretch_of(placement_.linear());
    const double height = cone_.upper - cone_.lower;
    return height / std::hypot(height, cone_.r2 - cone_.r1) * stretch.least / stretch.greatest;
  }
  [[nodiscard]] double thickness() const override {
    return std::min(cone_.upper - cone_.lower, 2 * std::max(cone_.r1, cone_.r2)) *
           stretch_of(placement_.linear()).least;
  }
  [[nodiscard]] bool convex() const override { return true; }

 private:
  RoundCone cone_;
  Eigen::Affine3d placement_;
};

class Ball final : public Leaf {
 public:
  Ball(double radius, const Eigen::Affine3d& placement) : radius_(radius), placement_(placement) {}
  [[nodiscard]] Shape solid(const Making& making) const override {
    const Stretch stretch = stretch_of(placement_.linear());
    if (stretch.is_even()) {
      const Vec3 at = placement_.translation();
      const frep::Expression ball = frep::shapes::sphere(radius_ * stretch.greatest + making.growth);
      return {remap(ball, Expression::x() - at.x(), Expression::y() - at.y(), Expression::z() - at.z())};
    }
    return {placed(frep::shapes::sphere(radius_ + making.growth / stretch.least), placement_)};
  }
  [[nodiscard]] Polyhedron polyhedron() const override {
    TurnedShape shape;
    Outline arc;
    constexpr int fine = 90;
    for (int i = 0; i <= fine; ++i) {
      const double angle = std::numbers::pi * i / fine;
      arc.emplace_back(i == 0 || i == fine ? 0 : radius_ * std::sin(angle), -radius_ * std::cos(angle));
    }
    return moved(turned({{arc}}, 0, std::numbers::pi / fine, 2 * fine, true), placement_);
  }
  [[nodiscard]] bool has_flat_faces() const override { return false; }
  [[nodiscard]] Box bounds() const override {
    // The extent of an ellipsoid along an axis is the length of that row of its map.
    const Vec3 reach = radius_ * placement_.linear().rowwise().norm();
    return {placement_.translation() - reach, placement_.translation() + reach};
  }
  [[nodiscard]] double steepness() const override {
    const Stretch stretch = stretch_of(placement_.linear());
    return stretch.least / stretch.greatest;
  }
  [[nodiscard]] double thickness() const override { return 2 * radius_ * stretch_of(placement_.linear()).least; }
  [[nodiscard]] bool convex() const override { return true; }
  [[nodiscard]] std::optional<BallShape> ball() const override {
    const Stretch stretch = stretch_of(placement_.linear());
    if (!stretch.is_even()) return std::nullopt;
    return BallShape{placement_.translation(), radius_ * stretch.greatest};
  }

 private:
  double radius_;
  Eigen::Affine3d placement_;
};

}  // namespace

FieldPtr Shape::as_field() const { return formula ? frep::make_field(frep::simplify(*formula)) : field; }

LeafPtr convex_leaf(Polyhedron solid) {
  if (solid.empty()) return nullptr;
  return std::make_shared<Convex>(std::move(solid));
}
LeafPtr mesh_leaf(Polyhedron solid) {
  if (solid.empty()) return nullptr;
  constexpr std::size_t many = 2000;  // triangles; larger solids are seldom convex, and faster to evaluate as a mesh
  if (solid.triangles.size() < many && is_closed(solid) && is_convex(solid)) return convex_leaf(std::move(solid));
  return std::make_shared<Mesh>(std::move(solid), 0);
}
LeafPtr rounded_leaf(Polyhedron solid, double radius) {
  if (solid.empty()) return nullptr;
  return std::make_shared<Mesh>(std::move(solid), radius);
}
LeafPtr extruded_leaf(const Region& region, double lower, double upper, const Eigen::Affine3d& placement) {
  if (region.empty() || !(upper > lower)) return nullptr;
  return std::make_shared<ExtrudedLeaf>(region, lower, upper, placement);
}
LeafPtr turned_leaf(TurnedShape shape, const Eigen::Affine3d& placement) {
  if (shape.profile.empty()) return nullptr;
  return std::make_shared<TurnedLeaf>(std::move(shape), placement);
}
LeafPtr faceted_leaf(Polyhedron solid, TurnedShape shape, const Eigen::Affine3d& placement) {
  if (solid.empty()) return nullptr;
  return std::make_shared<Faceted>(std::move(solid), std::move(shape), placement);
}
LeafPtr cone_leaf(const RoundCone& cone, const Eigen::Affine3d& placement) {
  if (!(cone.upper > cone.lower) || !(std::max(cone.r1, cone.r2) > 0)) return nullptr;
  return std::make_shared<Cone>(cone, placement);
}
LeafPtr ball_leaf(double radius, const Eigen::Affine3d& placement) {
  if (!(radius > 0)) return nullptr;
  return std::make_shared<Ball>(radius, placement);
}

}  // namespace fieldfab::openscad
