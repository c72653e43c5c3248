/// Operations over Fields: each takes Fields of any kind and yields a Field (Keeter 3.3, Tables 3.1 to 3.3).
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// min(a, b): the points in either.
FieldPtr unite(FieldPtr a, FieldPtr b);
/// max(a, b): the points in both.
FieldPtr intersect(FieldPtr a, FieldPtr b);
/// max(a, -b): the points of `a` that are not in `b`.
FieldPtr subtract(FieldPtr a, FieldPtr b);
/// -a: everything that is not in `a`.
FieldPtr complement(FieldPtr a);
/// a - distance: grown by `distance` mm where `a` is a distance field (shrunk where negative).
FieldPtr offset(FieldPtr a, double distance);
/// max(a - t/2, -t/2 - a): a wall of `thickness` mm about the surface (Table 3.3). Throws bad_input unless thickness > 0.
FieldPtr shell(const FieldPtr& a, double thickness);
/// min(min(a, b), sqrt|a| + sqrt|b| - sqrt(r)): a union with a rounded inner seam that reaches `radius` mm (Table 3.3).
FieldPtr blend(FieldPtr a, FieldPtr b, double radius);
/// (1 - weight) * a + weight * b: `a` at 0, `b` at 1 (Table 3.3).
FieldPtr morph(FieldPtr a, FieldPtr b, double weight);

/// Moved by `by` mm.
FieldPtr translate(FieldPtr a, const Vec3& by);
/// Scaled about the origin by a factor an axis; throws bad_input where one is zero. Values are multiplied by the least factor,
/// so that a distance field stays a lower bound of the distance.
FieldPtr scale(FieldPtr a, const Vec3& factors);
/// Turned about an axis through the origin by `angle` radians, right-handed.
FieldPtr rotate(FieldPtr a, const Vec3& axis, double angle);
/// Mirrored in the plane through the origin with the given normal.
FieldPtr mirror(FieldPtr a, const Vec3& normal);
/// Moved by any invertible affine map from the old place to the new; values are kept as they are.
FieldPtr transform(FieldPtr a, const Eigen::Affine3d& placement);
/// a(x', y', z') with x', y', z' given as Fields: the general map of Appendix A.
FieldPtr map(FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z);

/// The same solid with its values multiplied: by a factor above 0.
FieldPtr scaled_values(FieldPtr a, double factor);

/// The same Field, which knows a box that holds the solid.
FieldPtr with_known_bounds(FieldPtr a, const Box& bounds);

/// The box as an exact distance field inside, the largest axis distance outside; a flat axis yields an empty solid.
FieldPtr box_field(const Box& box);

/// The solid as an eye `distance` above `centre` sees it: what lies at height z appears magnified by distance / (distance - z), z
/// counted from the centre, and stays at its height. Good below the eye. Throws bad_input.
FieldPtr seen_from_near(FieldPtr a, const Vec3& centre, double distance);

}  // namespace fieldfab
