/// Shapes and operations on shapes, as expressions: the library behind .frep text and Python's fieldfab.shapes.
///
/// Lengths are mm, angles radians. Numbers may be expressions themselves, so that a radius may vary with x. "Exact":
/// the value is the signed distance to the surface everywhere. "Bound": its magnitude never exceeds that distance.
/// "Neither": only the sign is correct. library.h and docs/shapes.md give names in .frep text, defaults and pictures.
#pragma once

#include <span>
#include <string_view>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep::shapes {

using E = Expression;

// Solids, centred on the origin unless stated otherwise.
E sphere(const E& radius);                           ///< exact
E ellipsoid(const E& rx, const E& ry, const E& rz);  ///< half axes; neither
/// sides dx, dy, dz; a bound outside edges and corners, exact elsewhere
E box(const E& dx, const E& dy, const E& dz);
E exact_box(const E& dx, const E& dy, const E& dz);                     ///< exact
E rounded_box(const E& dx, const E& dy, const E& dz, const E& radius);  ///< edges rounded by `radius`; exact outside
E cylinder(const E& radius, const E& height);                           ///< along z; a bound
E exact_cylinder(const E& radius, const E& height);                     ///< along z; exact
E cone(const E& radius, const E& height);                               ///< base at z = -height/2; a bound
E exact_cone(const E& radius, const E& height);                         ///< base at z = -height/2; exact
E pyramid(const E& dx, const E& dy, const E& height);                   ///< base dx by dy at z = -height/2; a bound
/// ring radius in the xy plane, tube radius; exact
E torus(const E& ring, const E& tube);
E capsule(const E& radius, const E& length);  ///< along z, `length` between the centres of its caps; exact
E half_space(const E& nx, const E& ny, const E& nz, const E& offset);  ///< below the plane with that normal; exact

// Flat shapes, unbounded along z until extruded.
E circle(const E& radius);                                       ///< exact
E rectangle(const E& dx, const E& dy);                           ///< a bound
E exact_rectangle(const E& dx, const E& dy);                     ///< exact
E rounded_rectangle(const E& dx, const E& dy, const E& radius);  ///< exact outside
/// vertices in either orientation; a bound
E triangle(const E& x0, const E& y0, const E& x1, const E& y1, const E& x2, const E& y2);
E polygon(int sides, double radius);  ///< a regular polygon, vertices at distance `radius` from the centre; a bound
/// A simple polygon with vertices x0, y0, x1, y1 and so on, in either orientation; a bound. Throws Error(bad_input) for
/// fewer than three vertices. The result for a polygon that crosses itself is unspecified.
E outline(std::span<const double> coordinates);
/// a line segment with round ends; exact
E stroke(const E& x0, const E& y0, const E& x1, const E& y1, const E& width);
/// a rectangle whose lower side lies on the x axis; a bound
E tab(const E& width, const E& height);
/// A rectangle whose upper side lies on the x axis, with an opening widened by `chamfer` on both sides; a bound.
E slot(const E& width, const E& depth, const E& chamfer);
/// Text in a stroke font, along x from the origin. Capitals are `height` high, strokes `weight` thick. '\n' starts a
/// new line below. Unknown characters become boxes. Exact.
E text(std::string_view words, double height, double weight);

// Solids from flat shapes.
E extrude(const E& shape, const E& height, const E& base);  ///< from z = base to z = base + height
/// revolves the half x > 0 of a shape in the xy plane about y; y becomes z
E revolve(const E& shape);
E loft(const E& a, const E& b, const E& height);  ///< from a at z = 0 to b at z = height; neither

// Triply periodic minimal surfaces, negative on one side; shell() makes walls of them, whose thickness may vary.
// Neither.
E gyroid(const E& period);
E schwarz_p(const E& period);
E diamond(const E& period);

// Struts and walls without thickness, repeated without end: the value is the distance to the nearest one, never
// negative. shell() gives them their thickness, which may vary. Exact.
E cubic_struts(const E& period);     ///< edges of cubes, whose corners are at odd multiples of period / 2
E bcc_struts(const E& period);       ///< from the middle of each cube to its corners (body-centred cubic)
E fcc_struts(const E& period);       ///< diagonals of the cubes' faces (face-centred cubic)
E octet_struts(const E& period);     ///< those, and edges of octahedra between the middles of the faces
E honeycomb_walls(const E& period);  ///< hexagons along z; `period` is between opposite walls
/// Smooth walls without order, like a foam's: the zero set of twelve plane waves of wavelength `period`, of different
/// directions (Cahn 1965: spinodal decomposition). Negative on one side. Neither.
E spinodal(const E& period);

// Machine elements.
/// A flat involute gear. `module` is the pitch diameter divided by the number of teeth, mm; `pressure_angle` is in
/// radians. Teeth are thinner by `backlash` mm at the pitch circle. A bound.
E gear(int teeth, double module, double pressure_angle, double backlash);
/// A rod along z with an external ISO metric thread of major radius `radius`. Subtract a wider one for an internal
/// thread. Neither.
E thread(const E& radius, const E& pitch, const E& height);

// Set operations. The complement is negation.
E unite(const E& a, const E& b);
E intersect(const E& a, const E& b);
E subtract(const E& a, const E& b);
E offset(const E& a, const E& distance);            ///< expansion by `distance`; shrinks if negative
E shell(const E& a, const E& thickness);            ///< a wall centred on the surface
E clearance(const E& a, const E& b, const E& gap);  ///< a without b expanded by `gap`
E blend(const E& a, const E& b, const E& radius);   ///< union with a rounded seam (Keeter Table 3.3)
/// union with a circular fillet; exact inside, approximately a distance outside
E smooth_unite(const E& a, const E& b, const E& radius);
E smooth_intersect(const E& a, const E& b, const E& radius);  ///< intersection with a rounded edge
E smooth_subtract(const E& a, const E& b, const E& radius);   ///< difference with a rounded edge
E chamfer_unite(const E& a, const E& b, const E& size);       ///< union with a chamfer in the seam
E chamfer_intersect(const E& a, const E& b, const E& size);   ///< intersection with a chamfered edge
E chamfer_subtract(const E& a, const E& b, const E& size);    ///< difference with a chamfered edge
E morph(const E& a, const E& b, const E& weight);             ///< a at 0, b at 1

// Transformations and deformations.
E move(const E& a, const E& dx, const E& dy, const E& dz);
E rotate_x(const E& a, const E& angle);
E rotate_y(const E& a, const E& angle);
E rotate_z(const E& a, const E& angle);
E scale(const E& a, const E& factor);  ///< uniform; preserves distances
/// does not preserve distances; factors may vary with the position
E scale_xyz(const E& a, const E& sx, const E& sy, const E& sz);
E mirror_x(const E& a);  ///< reflection in the plane x = 0
E mirror_y(const E& a);
E mirror_z(const E& a);
E symmetric_x(const E& a);  ///< the half x > 0 and its mirror image
E symmetric_y(const E& a);
E symmetric_z(const E& a);
E shear_x_y(const E& a, const E& slope);                ///< x moved by slope * y
E shear_x_z(const E& a, const E& slope);                ///< x moved by slope * z
E twist(const E& a, const E& angle);                    ///< about z, by `angle` radians per mm
E taper(const E& a, const E& height, const E& factor);  ///< scales x and y from 1 at z = 0 to `factor` at z = height
/// bends the x axis upwards about an axis parallel to y, `radius` above the origin
E bend(const E& a, const E& radius);
/// Draws the solid towards a point, or pushes it away; the effect decays over `reach` mm (kokopelli's attract and
/// repel).
E attract(const E& a, const E& x, const E& y, const E& z, const E& reach);
E repel(const E& a, const E& x, const E& y, const E& z, const E& reach);
E repeat_x(const E& a, const E& period);  ///< infinite copies, centred on multiples of `period`
E repeat_y(const E& a, const E& period);
E repeat_z(const E& a, const E& period);
E array_x(const E& a, int count, const E& dx);  ///< copies at 0, dx, 2 dx and so on
E array_xy(const E& a, int columns, int rows, const E& dx, const E& dy);
E array_polar(const E& a, int count);  ///< copies rotated about z in equal steps

// Circuit boards: flat copper, and footprints centred on the origin. All bounds.
E trace(std::span<const double> coordinates, double width);  ///< through x0, y0, x1, y1 and so on; exact
/// two pads along x, centres `span` apart
E footprint_chip(double pad_dx, double pad_dy, double span);
E footprint_soic(int pins, double pitch, double span, double pad_dx, double pad_dy);  ///< two columns of pads
E footprint_header(int columns, int rows, double pitch, double pad);                  ///< round pads without holes

}  // namespace fieldfab::frep::shapes
