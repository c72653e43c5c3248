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

/// Convex hull; empty if the points lie in a plane.
Polyhedron convex_hull(std::span<const Vec3> points);
/// Planes of the faces of a convex polyhedron, each once.
std::vector<Plane> planes_of(const Polyhedron& convex);
/// Whether no corner is beyond the plane of a triangle, within rounding.
bool is_convex(const Polyhedron& solid);

/// Sweeps outlines through layers and joins the layers by triangles. `place` returns the position
/// of a point of the flat shape in each layer 0 to `steps`. Both ends get caps unless `choices`
/// disables them. Quadrilaterals are divided along the shorter diagonal. If both are equal,
/// `forwards_if_equal` selects the diagonal that goes forwards along the outline as it goes up.
struct SweepChoices {
  bool caps = true, forwards_if_equal = false;
};
Polyhedron sweep(const Region& region, int steps, const std::function<Vec3(const Vec2&, int)>& place,
                 const SweepChoices& choices = {});
/// Rotates outlines in the half plane x >= 0 about z, from the angle `first` in `steps` steps of
/// `step` radians. A full turn closes itself.
Polyhedron turned(const Region& profile, double first, double step, int steps, bool full);

/// Cross-section at z = 0.
Region slice(const Polyhedron& solid);
/// Shadow along z.
Region shadow(const Polyhedron& solid);

}  // namespace fieldfab::openscad
