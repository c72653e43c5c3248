/// Shapes and what is done with them, as expressions: the library behind .frep text and Python's fieldfab.shapes.
///
/// Lengths are mm, angles radians, numbers may be expressions themselves (so a radius may vary with x). "Exact" means that the
/// value is the signed distance to the surface everywhere; "bound" that it is never farther from 0 than that distance; else it is
/// neither.
#pragma once

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep::shapes {

using E = Expression;

// Solids, centred on the origin unless told otherwise.
E sphere(const E& radius);                     ///< exact
E box(const E& dx, const E& dy, const E& dz);  ///< sides dx, dy, dz; a bound outside of edges and corners
E rounded_box(const E& dx, const E& dy, const E& dz, const E& radius);  ///< edges rounded by `radius`; exact outside
E cylinder(const E& radius, const E& height);                           ///< along z; a bound
E cone(const E& radius, const E& height);                               ///< base at z = -height/2; a bound
E torus(const E& ring, const E& tube);                                  ///< ring radius in the xy plane, tube radius; exact
E capsule(const E& radius, const E& length);  ///< along z, `length` between the centres of its caps; exact
E half_space(const E& nx, const E& ny, const E& nz, const E& offset);  ///< below the plane with that normal; exact

// Flat shapes, unbounded along z until extruded.
E circle(const E& radius);                                       ///< exact
E rectangle(const E& dx, const E& dy);                           ///< a bound
E rounded_rectangle(const E& dx, const E& dy, const E& radius);  ///< exact outside
E polygon(int sides, double radius);                             ///< regular, corners at `radius`; a bound

// Solids from flat shapes.
E extrude(const E& shape, const E& low, const E& high);  ///< from z = low to z = high
E revolve(const E& shape);  ///< the half x > 0 of a shape in the xy plane turned about y, y becoming z

// Periodic surfaces, negative on one side; walls come from shell().
E gyroid(const E& period);
E schwarz_p(const E& period);
E diamond(const E& period);

// Sets. (complement is negation.)
E unite(const E& a, const E& b);
E intersect(const E& a, const E& b);
E subtract(const E& a, const E& b);
E offset(const E& a, const E& distance);                  ///< grown by `distance`
E shell(const E& a, const E& thickness);                  ///< a wall about the surface
E blend(const E& a, const E& b, const E& radius);         ///< union with a rounded seam (Keeter Table 3.3)
E smooth_unite(const E& a, const E& b, const E& radius);  ///< union with a circular fillet; exact in, distance-like outside
E morph(const E& a, const E& b, const E& weight);         ///< a at 0, b at 1

// Moving and bending.
E move(const E& a, const E& dx, const E& dy, const E& dz);
E rotate_x(const E& a, const E& angle);
E rotate_y(const E& a, const E& angle);
E rotate_z(const E& a, const E& angle);
E scale(const E& a, const E& factor);                            ///< keeps distances
E scale_xyz(const E& a, const E& sx, const E& sy, const E& sz);  ///< does not
E mirror_x(const E& a);                                          ///< in the plane x = 0
E mirror_y(const E& a);
E mirror_z(const E& a);
E twist(const E& a, const E& angle);                    ///< about z, by `angle` a mm
E taper(const E& a, const E& height, const E& factor);  ///< from full size at z = 0 to `factor` at z = height
E repeat_x(const E& a, const E& period);                ///< without end, copies centred on multiples of `period`
E repeat_y(const E& a, const E& period);
E repeat_z(const E& a, const E& period);

}  // namespace fieldfab::frep::shapes
