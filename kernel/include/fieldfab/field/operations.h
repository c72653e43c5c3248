/// Operations over Fields. Each takes Fields of any kind and returns a new Field that shares them (Keeter 3.3, Tables
/// 3.1 to 3.3). NaN in an argument of a set operation gives NaN, which is outside.
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// Union, min(a, b).
FieldPtr unite(FieldPtr a, FieldPtr b);
/// Intersection, max(a, b).
FieldPtr intersect(FieldPtr a, FieldPtr b);
/// Difference, max(a, -b): the points of `a` that are not in `b`.
FieldPtr subtract(FieldPtr a, FieldPtr b);
/// Complement, -a.
FieldPtr complement(FieldPtr a);
/// Offset, a - distance: expands the solid by `distance` mm if `a` is a distance field (shrinks it if negative).
FieldPtr offset(FieldPtr a, double distance);
/// Shell, max(a - t/2, -t/2 - a): a wall of `thickness` mm centred on the surface (Table 3.3). Throws Error(bad_input)
/// unless thickness > 0.
FieldPtr shell(const FieldPtr& a, double thickness);
/// Blend, min(min(a, b), sqrt|a| + sqrt|b| - sqrt(r)): a union with a rounded seam of radius `radius` mm (Table 3.3).
FieldPtr blend(FieldPtr a, FieldPtr b, double radius);
/// Linear interpolation, (1 - weight) * a + weight * b: `a` at weight 0, `b` at weight 1 (Table 3.3).
FieldPtr morph(FieldPtr a, FieldPtr b, double weight);

/// Translation by `by` mm.
FieldPtr translate(FieldPtr a, const Vec3& by);
/// Scaling about the origin by one factor per axis. Throws Error(bad_input) if a factor is zero. Values are multiplied
/// by the least factor, so that a distance field remains a lower bound of the distance.
FieldPtr scale(FieldPtr a, const Vec3& factors);
/// Right-handed rotation by `angle` radians about an axis through the origin.
FieldPtr rotate(FieldPtr a, const Vec3& axis, double angle);
/// Reflection in the plane through the origin with the given normal.
FieldPtr mirror(FieldPtr a, const Vec3& normal);
/// Placement by an invertible affine map from model space to the new position. Values are not scaled. Throws
/// Error(bad_input) for a singular or non-finite map.
FieldPtr transform(FieldPtr a, const Eigen::Affine3d& placement);
/// Substitution a(x', y', z') with x', y' and z' given as Fields: the general map of Keeter's Appendix A.
FieldPtr map(FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z);

/// The same solid with values multiplied by `factor` > 0.
FieldPtr scaled_values(FieldPtr a, double factor);

/// The same Field with known_bounds() set to `bounds`, which must contain the solid.
FieldPtr with_known_bounds(FieldPtr a, const Box& bounds);

/// A box as a Field: the exact signed distance inside, the largest axis distance outside. A flat box gives an empty
/// solid.
FieldPtr box_field(const Box& box);

/// Perspective view of a solid from an eye `distance` mm above `centre`. A point at height z above the centre is
/// magnified by distance / (distance - z) and keeps its height. Valid below the eye. Throws Error(bad_input) unless
/// distance > 0 and the centre is finite.
FieldPtr seen_from_near(FieldPtr a, const Vec3& centre, double distance);

}  // namespace fieldfab
