/// Shapes and what is done with them, as expressions: the library behind .frep text and Python's fieldfab.shapes.
///
/// Lengths are mm, angles radians, numbers may be expressions themselves (so a radius may vary with x). "Exact" means that the
/// value is the signed distance to the surface everywhere; "bound" that it is never farther from 0 than that distance; "neither"
/// that it has the right sign only. What each is called in .frep text, its defaults and a picture: library.h, docs/shapes.md.
#pragma once

#include <span>
#include <string_view>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep::shapes {

using E = Expression;

// Solids, centred on the origin unless told otherwise.
E sphere(const E& radius);                           ///< exact
E ellipsoid(const E& rx, const E& ry, const E& rz);  ///< half axes; neither
E box(const E& dx, const E& dy, const E& dz);        ///< sides dx, dy, dz; a bound outside of edges and corners
E exact_box(const E& dx, const E& dy, const E& dz);  ///< exact
E rounded_box(const E& dx, const E& dy, const E& dz, const E& radius);  ///< edges rounded by `radius`; exact outside
E cylinder(const E& radius, const E& height);                           ///< along z; a bound
E exact_cylinder(const E& radius, const E& height);                     ///< along z; exact
E cone(const E& radius, const E& height);                               ///< base at z = -height/2; a bound
E exact_cone(const E& radius, const E& height);                         ///< base at z = -height/2; exact
E pyramid(const E& dx, const E& dy, const E& height);                   ///< base dx by dy at z = -height/2; a bound
E torus(const E& ring, const E& tube);                                  ///< ring radius in the xy plane, tube radius; exact
E capsule(const E& radius, const E& length);  ///< along z, `length` between the centres of its caps; exact
E half_space(const E& nx, const E& ny, const E& nz, const E& offset);  ///< below the plane with that normal; exact

// Flat shapes, unbounded along z until extruded.
E circle(const E& radius);                                                                 ///< exact
E rectangle(const E& dx, const E& dy);                                                     ///< a bound
E exact_rectangle(const E& dx, const E& dy);                                               ///< exact
E rounded_rectangle(const E& dx, const E& dy, const E& radius);                            ///< exact outside
E triangle(const E& x0, const E& y0, const E& x1, const E& y1, const E& x2, const E& y2);  ///< either way round; a bound
E polygon(int sides, double radius);  ///< regular, corners at `radius`; a bound
/// A polygon through points x0, y0, x1, y1 ..., of any shape, either way round; a bound. Throws bad_input for fewer than three
/// points. One that crosses itself gives something, but not what its maker meant.
E outline(std::span<const double> coordinates);
E stroke(const E& x0, const E& y0, const E& x1, const E& y1, const E& width);  ///< a line with round ends; exact
E tab(const E& width, const E& height);                                        ///< a rectangle that stands on the x axis; a bound
/// A rectangle that hangs from the x axis, its mouth widened by `chamfer` on both sides; a bound.
E slot(const E& width, const E& depth, const E& chamfer);
/// Upright text in a stroke font, capitals `height` high and strokes `weight` thick, from the origin to the right; '\n' begins a
/// new line below. Characters that the font lacks are boxes. Exact.
E text(std::string_view words, double height, double weight);

// Solids from flat shapes.
E extrude(const E& shape, const E& height, const E& base);  ///< from z = base up
E revolve(const E& shape);                        ///< the half x > 0 of a shape in the xy plane turned about y, y becoming z
E loft(const E& a, const E& b, const E& height);  ///< from a at z = 0 to b at z = height; neither

// Periodic surfaces, negative on one side; walls, of a thickness that may vary, come from shell(). Neither.
E gyroid(const E& period);
E schwarz_p(const E& period);
E diamond(const E& period);

// Things to make.
/// An involute gear, flat: `module` is its pitch diameter divided by its teeth; teeth are thinner by `backlash` at the pitch
/// circle. A bound.
E gear(int teeth, double module, double pressure_angle, double backlash);
/// A rod along z with an ISO metric thread of `radius` outside; what it screws into is a difference with a wider one. Neither.
E thread(const E& radius, const E& pitch, const E& height);

// Sets. (complement is negation.)
E unite(const E& a, const E& b);
E intersect(const E& a, const E& b);
E subtract(const E& a, const E& b);
E offset(const E& a, const E& distance);                      ///< grown by `distance`
E shell(const E& a, const E& thickness);                      ///< a wall about the surface
E clearance(const E& a, const E& b, const E& gap);            ///< a less b, with room for b
E blend(const E& a, const E& b, const E& radius);             ///< union with a rounded seam (Keeter Table 3.3)
E smooth_unite(const E& a, const E& b, const E& radius);      ///< union with a circular fillet; exact in, distance-like outside
E smooth_intersect(const E& a, const E& b, const E& radius);  ///< intersection with a rounded edge
E smooth_subtract(const E& a, const E& b, const E& radius);   ///< difference with a rounded edge
E chamfer_unite(const E& a, const E& b, const E& size);       ///< union with a flat fillet
E chamfer_intersect(const E& a, const E& b, const E& size);   ///< intersection with the edge cut off
E chamfer_subtract(const E& a, const E& b, const E& size);    ///< difference with the edge cut off
E morph(const E& a, const E& b, const E& weight);             ///< a at 0, b at 1

// Moving and bending.
E move(const E& a, const E& dx, const E& dy, const E& dz);
E rotate_x(const E& a, const E& angle);
E rotate_y(const E& a, const E& angle);
E rotate_z(const E& a, const E& angle);
E scale(const E& a, const E& factor);                            ///< keeps distances
E scale_xyz(const E& a, const E& sx, const E& sy, const E& sz);  ///< does not; factors may vary with the position
E mirror_x(const E& a);                                          ///< in the plane x = 0
E mirror_y(const E& a);
E mirror_z(const E& a);
E symmetric_x(const E& a);  ///< the half x > 0, and its mirror image
E symmetric_y(const E& a);
E symmetric_z(const E& a);
E shear_x_y(const E& a, const E& slope);                ///< x moved by slope * y
E shear_x_z(const E& a, const E& slope);                ///< x moved by slope * z
E twist(const E& a, const E& angle);                    ///< about z, by `angle` a mm
E taper(const E& a, const E& height, const E& factor);  ///< from full size at z = 0 to `factor` at z = height
E bend(const E& a, const E& radius);  ///< what lies along x is bent upwards about an axis along y, `radius` above the origin
/// What is near a point is drawn to it or driven from it, less and less over `reach` (kokopelli's attract and repel).
E attract(const E& a, const E& x, const E& y, const E& z, const E& reach);
E repel(const E& a, const E& x, const E& y, const E& z, const E& reach);
E repeat_x(const E& a, const E& period);  ///< without end, copies centred on multiples of `period`
E repeat_y(const E& a, const E& period);
E repeat_z(const E& a, const E& period);
E array_x(const E& a, int count, const E& dx);  ///< copies at 0, dx, 2 dx ...
E array_xy(const E& a, int columns, int rows, const E& dx, const E& dy);
E array_polar(const E& a, int count);  ///< copies turned about z

// Circuit boards: flat copper, and footprints centred on the origin. All bounds.
E trace(std::span<const double> coordinates, double width);   ///< through x0, y0, x1, y1 ...; exact
E footprint_chip(double pad_dx, double pad_dy, double span);  ///< two pads side by side in x, their centres `span` apart
E footprint_soic(int pins, double pitch, double span, double pad_dx, double pad_dy);  ///< two columns of pads
E footprint_header(int columns, int rows, double pitch, double pad);  ///< round pads; holes are circles of one's own

}  // namespace fieldfab::frep::shapes
