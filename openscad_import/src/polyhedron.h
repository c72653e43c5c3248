/// Polyhedra made of points and outlines.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fieldfab/mesh/polyhedron.h"
#include "flat.h"

namespace fieldfab::openscad {

using Triangle = Polyhedron::Triangle;

/// normal * p <= offset; the normal has length 1.
struct Plane {
  Vec3 normal;
  double offset;
};

/// The convex hull; empty where the points lie in a plane.
Polyhedron convex_hull(std::span<const Vec3> points);
/// The planes of a convex polyhedron's faces, each once.
std::vector<Plane> planes_of(const Polyhedron& convex);
/// Whether no corner is beyond the plane of a triangle, by more than rounding.
bool is_convex(const Polyhedron& solid);

/// Outlines in layers, joined by triangles; `place` tells where a point of the flat shape is in each layer of 0 to `steps`. With
/// caps at both ends unless told otherwise. Four-sided faces are divided by their shorter diagonal; where both are as long, by
/// that which goes forwards along the outline as it goes up, or by the other.
struct SweepChoices {
  bool caps = true, forwards_if_equal = false;
};
Polyhedron sweep(const Region& region, int steps, const std::function<Vec3(const Vec2&, int)>& place,
                 const SweepChoices& choices = {});
/// Outlines in the half plane x >= 0 turned about z, first at the angle `first` and then by `step` radians `steps` times; a full
/// turn closes itself.
Polyhedron turned(const Region& profile, double first, double step, int steps, bool full);

/// Where a plane z = 0 cuts it.
Region slice(const Polyhedron& solid);
/// Its shadow along z.
Region shadow(const Polyhedron& solid);

}  // namespace fieldfab::openscad
