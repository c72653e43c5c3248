#include "fieldfab/frep/library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <unordered_map>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab::frep {
namespace {

using A = const Arguments&;
using Functions = std::vector<LibraryFunction>;
constexpr Quantity angle = Quantity::angle, number = Quantity::number, whole = Quantity::whole;
constexpr Quantity any = Quantity::expression;

Parameter given(std::string_view name) { return {name}; }
Parameter with(std::string_view name, double fallback) { return {name, any, fallback}; }

/// Operations of expressions, in their written form.
void add_operations(Functions& all) {
  for (int i = static_cast<int>(Opcode::sine); i < opcode_count; ++i) {
    const auto op = static_cast<Opcode>(i);
    const OpcodeInfo& about = info(op);
    if (about.infix.size() < 2 || op == Opcode::minimum || op == Opcode::maximum) continue;
    if (about.arity == 1)
      all.push_back(
          {about.infix, "numbers", {given("value")}, "", "", "", [op](A a) { return Expression::make(op, a[0]); }});
    else
      all.push_back({about.infix, "numbers", {given("a"), given("b")}, "", "", "", [op](A a) {
                       return Expression::make(op, a[0], a[1]);
                     }});
  }
  all.push_back({"pow", "numbers", {given("a"), given("b")}, "", "", "", [](A a) {
                   return Expression::make(Opcode::power, a[0], a[1]);
                 }});
}

/// Conversions between solids and numbers, which decide the meaning of `-` and `+`.
void add_kinds(Functions& all) {
  all.push_back({"value",
                 "numbers",
                 {given("shape")},
                 "",
                 "the value of a solid at each point, as a number to reckon with",
                 "",
                 [](A a) { return a[0]; }});
}

template <class Join>
auto joined_by(const Join& join) {
  return [join](A a) {
    Expression result = a[0];
    for (std::size_t i = 1; i < a.values.size(); ++i) result = join(result, a[i]);
    return result;
  };
}

void add_solids(Functions& all) {
  using namespace shapes;
  const char* const group = "Solids";
  all.push_back({"sphere", group, {with("r", 1)}, "exact", "a ball", "sphere(5)", [](A a) { return sphere(a[0]); }});
  all.push_back({"ellipsoid",
                 group,
                 {with("rx", 1), with("ry", 1), with("rz", 1)},
                 "neither",
                 "half axes rx, ry, rz",
                 "ellipsoid(6, 4, 2)",
                 [](A a) { return ellipsoid(a[0], a[1], a[2]); }});
  all.push_back({"box",
                 group,
                 {with("dx", 1), with("dy", 1), with("dz", 1)},
                 "bound",
                 "sides dx, dy, dz; grown, it keeps its edges",
                 "box(8, 6, 4)",
                 [](A a) { return box(a[0], a[1], a[2]); }});
  all.push_back({"exact_box",
                 group,
                 {with("dx", 1), with("dy", 1), with("dz", 1)},
                 "exact",
                 "a box that gets round edges when grown",
                 "exact_box(6, 4, 2) - 1",
                 [](A a) { return exact_box(a[0], a[1], a[2]); }});
  all.push_back({"rounded_box",
                 group,
                 {with("dx", 1), with("dy", 1), with("dz", 1), with("r", 0.1)},
                 "exact",
                 "edges and corners rounded by r (exact outside)",
                 "rounded_box(8, 6, 4, 1)",
                 [](A a) { return rounded_box(a[0], a[1], a[2], a[3]); }});
  all.push_back({"cylinder", group, {with("r", 1), with("h", 1)}, "bound", "along z", "cylinder(3, 6)", [](A a) {
                   return cylinder(a[0], a[1]);
                 }});
  all.push_back({"exact_cylinder",
                 group,
                 {with("r", 1), with("h", 1)},
                 "exact",
                 "along z; grown, it gets round edges",
                 "exact_cylinder(2, 4) - 1",
                 [](A a) { return exact_cylinder(a[0], a[1]); }});
  all.push_back({"cone",
                 group,
                 {with("r", 1), with("h", 1)},
                 "bound",
                 "its base of radius r at z = -h/2, its tip at h/2",
                 "cone(4, 6)",
                 [](A a) { return cone(a[0], a[1]); }});
  all.push_back({"exact_cone",
                 group,
                 {with("r", 1), with("h", 1)},
                 "exact",
                 "the same; grown, it gets a round tip and edge",
                 "exact_cone(3, 5) - 1",
                 [](A a) { return exact_cone(a[0], a[1]); }});
  all.push_back({"pyramid",
                 group,
                 {with("dx", 1), with("dy", 1), with("h", 1)},
                 "bound",
                 "its base dx by dy at z = -h/2, its tip at h/2",
                 "pyramid(7, 6, 6)",
                 [](A a) { return pyramid(a[0], a[1], a[2]); }});
  all.push_back({"torus",
                 group,
                 {with("R", 1), with("r", 0.25)},
                 "exact",
                 "a ring in the xy plane; R to the middle of its tube",
                 "torus(4, 1.5)",
                 [](A a) { return torus(a[0], a[1]); }});
  all.push_back({"capsule",
                 group,
                 {with("r", 1), with("length", 1)},
                 "exact",
                 "along z, with round ends; length is between their centres",
                 "capsule(2, 5)",
                 [](A a) { return capsule(a[0], a[1]); }});
  all.push_back({"plane",
                 group,
                 {with("nx", 0), with("ny", 0), with("nz", 1), with("offset", 0)},
                 "exact",
                 "all that is below a plane with that normal, offset from the origin",
                 "plane(1, 1, 1, 2) & box(8, 8, 8)",
                 [](A a) { return half_space(a[0], a[1], a[2], a[3]); }});
  all.push_back({"thread",
                 group,
                 {with("r", 3), with("pitch", 1), with("h", 10)},
                 "neither",
                 "a rod with an ISO metric thread of outer radius r; for a nut take away one a little wider",
                 "thread(4, 1.25, 8)",
                 [](A a) { return thread(a[0], a[1], a[2]); }});
}

void add_flat(Functions& all) {
  using namespace shapes;
  const char* const group = "Flat shapes";
  all.push_back(
      {"circle", group, {with("r", 1)}, "exact", "", "extrude(circle(4), 1)", [](A a) { return circle(a[0]); }});
  all.push_back({"rectangle",
                 group,
                 {with("dx", 1), with("dy", 1)},
                 "bound",
                 "grown, it keeps its corners",
                 "extrude(rectangle(8, 5), 1)",
                 [](A a) { return rectangle(a[0], a[1]); }});
  all.push_back({"exact_rectangle",
                 group,
                 {with("dx", 1), with("dy", 1)},
                 "exact",
                 "grown, it gets round corners",
                 "extrude(exact_rectangle(6, 3) - 1, 1)",
                 [](A a) { return exact_rectangle(a[0], a[1]); }});
  all.push_back({"rounded_rectangle",
                 group,
                 {with("dx", 1), with("dy", 1), with("r", 0.1)},
                 "exact",
                 "(exact outside)",
                 "extrude(rounded_rectangle(8, 5, 1.5), 1)",
                 [](A a) { return rounded_rectangle(a[0], a[1], a[2]); }});
  all.push_back({"triangle",
                 group,
                 {with("x0", 0), with("y0", 0), with("x1", 1), with("y1", 0), with("x2", 0), with("y2", 1)},
                 "bound",
                 "by its corners, either way round",
                 "extrude(triangle(-4, -3, 4, -2, 0, 4), 1)",
                 [](A a) { return triangle(a[0], a[1], a[2], a[3], a[4], a[5]); }});
  all.push_back({"polygon",
                 group,
                 {{"sides", whole, 6}, {"r", number, 1}},
                 "bound",
                 "regular, its corners at r",
                 "extrude(polygon(5, 4), 1)",
                 [](A a) { return polygon(a.whole(0), a.number(1)); }});
  all.push_back({"outline",
                 group,
                 {{"x0", number}, {"y0", number}},
                 "bound",
                 "a polygon of any shape through points x0, y0, x1, y1, ...",
                 "extrude(outline(-4,-3, 4,-3, 4,3, 1,3, 1,0, -1,0, -1,3, -4,3), 1)",
                 [](A a) { return outline(a.numbers(0)); },
                 true});
  all.push_back({"stroke",
                 group,
                 {with("x0", 0), with("y0", 0), with("x1", 1), with("y1", 0), with("width", 0.5)},
                 "exact",
                 "a line with round ends",
                 "extrude(stroke(-3, -2, 3, 2, 2), 1)",
                 [](A a) { return stroke(a[0], a[1], a[2], a[3], a[4]); }});
  all.push_back({"tab",
                 group,
                 {with("width", 1), with("height", 1)},
                 "bound",
                 "stands on the x axis",
                 "extrude(tab(3, 2) | move(rectangle(8, 3), 0, -1.5), 1)",
                 [](A a) { return tab(a[0], a[1]); }});
  all.push_back({"slot",
                 group,
                 {with("width", 1), with("depth", 1), with("chamfer", 0)},
                 "bound",
                 "hangs from the x axis, its mouth widened by the chamfer",
                 "extrude(difference(move(rectangle(8, 5), 0, -2.5), slot(2, 3, 0.7)), 1)",
                 [](A a) { return slot(a[0], a[1], a[2]); }});
  all.push_back({"text",
                 group,
                 {{"words", Quantity::text}, {"h", number, 5}, {"weight", number, 0.8}},
                 "exact",
                 "upright, capitals h high and strokes weight thick; \\n begins a new line",
                 "extrude(text(\"Field\\nfab\", 5, 0.9), 1)",
                 [](A a) { return text(a.text, a.number(1), a.number(2)); }});
  all.push_back({"gear",
                 group,
                 {{"teeth", whole, 20}, {"module", number, 1}, {"pressure_angle", angle, 20}, {"backlash", number, 0}},
                 "bound",
                 "an involute gear; its pitch diameter is teeth times module",
                 "extrude(gear(16, 1), 2)",
                 [](A a) {
                   const Expression turned = simplify(a[2]);
                   if (turned.opcode() != Opcode::constant)
                     throw Error(ErrorKind::bad_input, "gear", "pressure_angle must be a plain number");
                   return gear(a.whole(0), a.number(1), turned.constant(), a.number(3));
                 }});
  all.push_back({"extrude",
                 "From flat to solid",
                 {given("shape"), with("h", 1), with("base", 0)},
                 "",
                 "from z = base up by h",
                 "extrude(polygon(6, 3), 5)",
                 [](A a) { return extrude(a[0], a[1], a[2]); }});
  all.push_back({"revolve",
                 "From flat to solid",
                 {given("shape")},
                 "",
                 "the half x > 0 turned about y, which becomes z",
                 "revolve(move(rectangle(2, 4), 3))",
                 [](A a) { return revolve(a[0]); }});
  all.push_back({"loft",
                 "From flat to solid",
                 {given("a"), given("b"), with("h", 1)},
                 "",
                 "from a at z = 0 to b at z = h",
                 "loft(circle(4), rectangle(4, 4), 6)",
                 [](A a) { return loft(a[0], a[1], a[2]); }});
}

void add_lattices(Functions& all) {
  using namespace shapes;
  const char* const group = "Lattices";
  const auto repeated = [&](std::string_view name, std::string_view quality, std::string_view meaning,
                            std::string_view example, E (*make)(const E&)) {
    all.push_back({name, group, {with("period", 1)}, quality, meaning, example, [make](A a) { return make(a[0]); }});
  };
  repeated("gyroid", "neither", "give it walls with shell; their thickness may vary",
           "shell(gyroid(5), 0.8 + z / 12) & box(10, 10, 10)", gyroid);
  repeated("schwarz_p", "neither", "the same", "shell(schwarz_p(5), 0.8) & box(10, 10, 10)", schwarz_p);
  repeated("diamond", "neither", "the same", "shell(diamond(5), 0.8) & sphere(6)", diamond);
  repeated("cubic_struts", "exact", "edges of cubes; shell gives struts their thickness, which may vary",
           "shell(cubic_struts(5), 0.6) & box(5.6, 5.6, 5.6)", cubic_struts);
  repeated("bcc_struts", "exact", "from the middle of each cube to its corners (body-centred cubic)",
           "shell(bcc_struts(5), 0.6) & box(5.6, 5.6, 5.6)", bcc_struts);
  repeated("fcc_struts", "exact", "diagonals of the cubes' faces (face-centred cubic)",
           "shell(fcc_struts(5), 0.6) & box(5.6, 5.6, 5.6)", fcc_struts);
  repeated("octet_struts", "exact", "those, and octahedra between the middles of the faces",
           "shell(octet_struts(5), 0.4) & box(5.4, 5.4, 5.4)", octet_struts);
  repeated("honeycomb_walls", "exact", "hexagons along z; the period is between opposite walls",
           "shell(honeycomb_walls(3), 0.6) & box(12, 12, 4)", honeycomb_walls);
  repeated("spinodal", "neither", "smooth walls without order, like a foam's", "shell(spinodal(6), 0.8) & sphere(8)",
           spinodal);
}

void add_sets(Functions& all) {
  using namespace shapes;
  const char* const group = "Sets";
  const auto chain = [&](std::string_view name, std::string_view in, std::string_view meaning, std::string_view example,
                         auto join) {
    all.push_back({name, in, {given("a"), given("b")}, "", meaning, example, joined_by(join), true});
  };
  const auto smallest = [](const Expression& a, const Expression& b) {
    return Expression::make(Opcode::minimum, a, b);
  };
  const auto largest = [](const Expression& a, const Expression& b) { return Expression::make(Opcode::maximum, a, b); };
  chain("min", "numbers", "", "", smallest);
  chain("max", "numbers", "", "", largest);
  chain("union", group, "of two or more; also a | b", "union(box(6, 6, 3), cylinder(2, 6))", smallest);
  chain("intersection", group, "of two or more; also a & b", "intersection(box(6, 6, 6), sphere(3.8))", largest);
  chain("difference", group, "the first less the others", "difference(box(6, 6, 4), cylinder(2, 6))", subtract);
  all.push_back({"solid",
                 group,
                 {given("formula")},
                 "",
                 "a formula as a solid: what is below 0",
                 "solid(x^2 + y^2 + z^2 - 16) - cylinder(2, 10)",
                 [](A a) { return a[0]; }});
  all.push_back({"offset",
                 group,
                 {given("shape"), given("distance")},
                 "",
                 "grown; shrunk where the distance is below 0",
                 "offset(exact_box(6, 4, 2), 1)",
                 [](A a) { return offset(a[0], a[1]); }});
  all.push_back({"shell",
                 group,
                 {given("shape"), given("thickness")},
                 "",
                 "a wall about the surface",
                 "shell(sphere(4), 0.6) & plane(0, -1, 0, 0)",
                 [](A a) { return shell(a[0], a[1]); }});
  all.push_back({"clearance",
                 group,
                 {given("a"), given("b"), with("gap", 0.2)},
                 "",
                 "a less b, with room for b",
                 "clearance(box(8, 8, 3), gear(8, 0.6), 0.5) | extrude(gear(8, 0.6), 2)",
                 [](A a) { return clearance(a[0], a[1], a[2]); }});
  all.push_back({"blend",
                 group,
                 {given("a"), given("b"), with("r", 1)},
                 "",
                 "union with a rounded seam (Keeter, Table 3.3)",
                 "blend(move(sphere(3), -2.6), move(sphere(2), 3), 1.5)",
                 [](A a) { return blend(a[0], a[1], a[2]); }});
  const auto two = [&](std::string_view name, std::string_view size, std::string_view meaning, std::string_view example,
                       auto make) {
    all.push_back({name, group, {given("a"), given("b"), with(size, 1)}, "", meaning, example, [make](A a) {
                     return make(a[0], a[1], a[2]);
                   }});
  };
  two("smooth_union", "r", "union with a round fillet",
      "smooth_union(box(8, 8, 2), move(cylinder(2, 6), 0, 0, 3), 1.5)", smooth_unite);
  two("smooth_intersection", "r", "intersection with a round edge", "smooth_intersection(box(6, 6, 6), sphere(4), 1)",
      smooth_intersect);
  two("smooth_difference", "r", "difference with a round edge", "smooth_difference(box(8, 8, 4), cylinder(2, 6), 1)",
      smooth_subtract);
  two("chamfer_union", "size", "union with a flat fillet",
      "chamfer_union(box(8, 8, 2), move(cylinder(2, 6), 0, 0, 3), 1.5)", chamfer_unite);
  two("chamfer_intersection", "size", "intersection with the edge cut off",
      "chamfer_intersection(cylinder(4, 20), box(20, 20, 5), 1)", chamfer_intersect);
  two("chamfer_difference", "size", "difference with the edge cut off",
      "chamfer_difference(box(8, 8, 4), cylinder(2, 6), 1)", chamfer_subtract);
  all.push_back({"morph",
                 group,
                 {given("a"), given("b"), with("weight", 0.5)},
                 "",
                 "between a at 0 and b at 1",
                 "morph(sphere(4), box(6, 6, 6), 0.5)",
                 [](A a) { return morph(a[0], a[1], a[2]); }});
}

void add_moves(Functions& all) {
  using namespace shapes;
  const char* const group = "Moving and bending";
  const Parameter shape = given("shape");
  all.push_back({"move",
                 group,
                 {shape, with("dx", 0), with("dy", 0), with("dz", 0)},
                 "",
                 "",
                 "box(4, 4, 4) | move(sphere(2), 2, 2, 2)",
                 [](A a) { return move(a[0], a[1], a[2], a[3]); }});
  const auto turned = [&](std::string_view name, std::string_view example, auto make) {
    all.push_back({name,
                   group,
                   {shape, {"angle", angle}},
                   "",
                   "anticlockwise, seen from where the axis points",
                   example,
                   [make](A a) { return make(a[0], a[1]); }});
  };
  turned("rotate_x", "rotate_x(box(8, 4, 2), 30)", rotate_x);
  turned("rotate_y", "rotate_y(box(8, 4, 2), 30)", rotate_y);
  turned("rotate_z", "rotate_z(box(8, 4, 2), 30)", rotate_z);
  all.push_back({"scale", group, {shape, given("factor")}, "", "keeps distances", "scale(torus(2, 0.7), 2)", [](A a) {
                   return scale(a[0], a[1]);
                 }});
  all.push_back({"scale_xyz",
                 group,
                 {shape, with("sx", 1), with("sy", 1), with("sz", 1)},
                 "",
                 "does not keep distances; the factors may vary with the position",
                 "scale_xyz(cylinder(3, 8), 1 + 0.3 * cos(z), 1, 1)",
                 [](A a) { return scale_xyz(a[0], a[1], a[2], a[3]); }});
  const auto plain = [&](std::string_view name, std::string_view meaning, std::string_view example, auto make) {
    all.push_back({name, group, {shape}, "", meaning, example, [make](A a) { return make(a[0]); }});
  };
  plain("mirror_x", "in the plane x = 0", "mirror_x(move(cone(2, 4), 3)) | box(1, 1, 4)", mirror_x);
  plain("mirror_y", "in the plane y = 0", "mirror_y(move(cone(2, 4), 0, 3)) | box(1, 1, 4)", mirror_y);
  plain("mirror_z", "in the plane z = 0", "mirror_z(cone(3, 6))", mirror_z);
  plain("symmetric_x", "the half x > 0 and its mirror image", "symmetric_x(move(sphere(2), 3))", symmetric_x);
  plain("symmetric_y", "the half y > 0 and its mirror image", "symmetric_y(move(sphere(2), 0, 3))", symmetric_y);
  plain("symmetric_z", "the half z > 0 and its mirror image", "symmetric_z(move(cone(2, 4), 0, 0, 1.5))", symmetric_z);
  const auto one = [&](std::string_view name, Parameter how, std::string_view meaning, std::string_view example,
                       auto make) {
    all.push_back({name, group, {shape, how}, "", meaning, example, [make](A a) { return make(a[0], a[1]); }});
  };
  one("shear_x_y", given("slope"), "x moved by slope * y", "shear_x_y(box(4, 6, 2), 0.5)", shear_x_y);
  one("shear_x_z", given("slope"), "x moved by slope * z", "shear_x_z(box(4, 3, 6), 0.5)", shear_x_z);
  one("twist", {"angle_per_mm", angle}, "about z", "twist(box(5, 5, 10), 9)", twist);
  all.push_back({"taper",
                 group,
                 {shape, given("height"), given("factor")},
                 "",
                 "full size at z = 0, factor times that at z = height",
                 "taper(extrude(rectangle(6, 6), 6), 6, 0.4)",
                 [](A a) { return taper(a[0], a[1], a[2]); }});
  one("bend", given("r"), "what lies along x is bent upwards about an axis along y, r above the origin",
      "bend(box(14, 3, 1), 5)", bend);
  const auto pulled = [&](std::string_view name, std::string_view meaning, std::string_view example, auto make) {
    all.push_back({name,
                   group,
                   {shape, with("px", 0), with("py", 0), with("pz", 0), with("reach", 1)},
                   "",
                   meaning,
                   example,
                   [make](A a) { return make(a[0], a[1], a[2], a[3], a[4]); }});
  };
  pulled("attract", "drawn to a point, less and less over reach", "attract(box(6, 6, 6), 0, 0, 3, 2)", attract);
  pulled("repel", "driven from a point, less and less over reach", "repel(box(6, 6, 2), 0, 0, 0, 2)", repel);
  one("repeat_x", given("period"), "without end", "repeat_x(sphere(1), 3) & box(10, 5, 5)", repeat_x);
  one("repeat_y", given("period"), "without end", "repeat_y(sphere(1), 3) & box(5, 10, 5)", repeat_y);
  one("repeat_z", given("period"), "without end", "repeat_z(sphere(1), 3) & box(5, 5, 10)", repeat_z);
  all.push_back({"array_x",
                 group,
                 {shape, {"count", whole, 2}, with("dx", 1)},
                 "",
                 "copies at 0, dx, 2 dx, ...",
                 "array_x(cylinder(1, 3), 4, 2.5)",
                 [](A a) { return array_x(a[0], a.whole(1), a[2]); }});
  all.push_back({"array_xy",
                 group,
                 {shape, {"columns", whole, 2}, {"rows", whole, 2}, with("dx", 1), with("dy", 1)},
                 "",
                 "",
                 "array_xy(cylinder(1, 3), 3, 3, 2.5, 2.5)",
                 [](A a) { return array_xy(a[0], a.whole(1), a.whole(2), a[3], a[4]); }});
  one("array_polar", {"count", whole}, "turned about z", "array_polar(move(cylinder(1, 3), 4), 7)",
      [](const Expression& a, const Expression& count) { return array_polar(a, static_cast<int>(count.constant())); });
  all.push_back({"map",
                 group,
                 {shape, given("x"), given("y"), given("z")},
                 "",
                 "with x, y and z replaced",
                 "map(box(8, 2, 4), x, y + sin(x), z)",
                 [](A a) { return remap(a[0], a[1], a[2], a[3]); }});
}

void add_circuits(Functions& all) {
  using namespace shapes;
  const char* const group = "Circuit boards (flat copper)";
  const auto millimetres = [](std::string_view name, double fallback) { return Parameter{name, number, fallback}; };
  all.push_back({"trace",
                 group,
                 {millimetres("width", 0.4), {"x0", number}, {"y0", number}},
                 "exact",
                 "through points x0, y0, x1, y1, ...",
                 "extrude(trace(0.5, -4,-2, 0,-2, 2,2, 4,2), 0.2)",
                 [](A a) { return trace(a.numbers(1), a.number(0)); },
                 true});
  all.push_back({"footprint_chip",
                 group,
                 {millimetres("pad_dx", 1.6), millimetres("pad_dy", 1.8), millimetres("span", 3.4)},
                 "bound",
                 "two pads, their centres span apart: 1206 as it stands, 0805 is (1.3, 1.5, 2.1)",
                 "extrude(footprint_chip(), 0.2)",
                 [](A a) { return footprint_chip(a.number(0), a.number(1), a.number(2)); }});
  all.push_back({"footprint_soic",
                 group,
                 {{"pins", whole, 8},
                  millimetres("pitch", 1.27),
                  millimetres("span", 5.4),
                  millimetres("pad_dx", 1.6),
                  millimetres("pad_dy", 0.6)},
                 "bound",
                 "two columns of pads: SOIC-8 as it stands",
                 "extrude(footprint_soic(14), 0.2)",
                 [](A a) { return footprint_soic(a.whole(0), a.number(1), a.number(2), a.number(3), a.number(4)); }});
  all.push_back({"footprint_header",
                 group,
                 {{"columns", whole, 2}, {"rows", whole, 3}, millimetres("pitch", 2.54), millimetres("pad", 1.7)},
                 "bound",
                 "round pads in rows; its holes are another one with smaller pads",
                 "extrude(difference(footprint_header(3, 2), footprint_header(3, 2, 2.54, 1)), 0.2)",
                 [](A a) { return footprint_header(a.whole(0), a.whole(1), a.number(2), a.number(3)); }});
}

Functions make_library() {
  Functions all;
  add_operations(all);
  add_kinds(all);
  add_solids(all);
  add_flat(all);
  add_lattices(all);
  add_sets(all);
  add_moves(all);
  add_circuits(all);
  return all;
}

/// Returns an argument, simplified. Throws bad_input if the parameter requires a number and the
/// argument is not one.
Expression plain(const Expression& argument, const LibraryFunction& function, const Parameter& parameter) {
  Expression value = simplify(argument);
  const auto refuse = [&](const char* what) {
    throw Error(ErrorKind::bad_input, "",
                fmt::format("'{}' of '{}' must be a plain {}", parameter.name, function.name, what));
  };
  if (parameter.quantity == Quantity::number && value.opcode() != Opcode::constant) refuse("number");
  if (parameter.quantity == Quantity::whole &&
      (value.opcode() != Opcode::constant || std::abs(value.constant()) > 1e6 ||
       std::floor(value.constant()) != value.constant()))
    refuse("whole number");
  return value;
}

}  // namespace

std::vector<double> Arguments::numbers(std::size_t first) const {
  std::vector<double> all;
  for (std::size_t i = first; i < values.size(); ++i) all.push_back(values[i].constant());
  return all;
}

const std::vector<LibraryFunction>& library() {
  static const Functions functions = make_library();
  return functions;
}

const LibraryFunction* find_function(std::string_view name) {
  static const auto by_name = [] {
    std::unordered_map<std::string_view, const LibraryFunction*> table;
    for (const LibraryFunction& function : library()) table.emplace(function.name, &function);
    return table;
  }();
  const auto found = by_name.find(name);
  return found == by_name.end() ? nullptr : found->second;
}

std::string signature(const LibraryFunction& function) {
  std::vector<std::string> shown;
  for (const Parameter& parameter : function.parameters) {
    const char* const unit = parameter.quantity == Quantity::angle ? "°" : "";
    shown.push_back(parameter.fallback ? fmt::format("{} = {:g}{}", parameter.name, *parameter.fallback, unit)
                                       : fmt::format("{}{}", parameter.name, unit));
  }
  if (function.any_number) shown.emplace_back("…");
  return fmt::format("{}({})", function.name, fmt::join(shown, ", "));
}

std::string meaning(const LibraryFunction& function) {
  const std::string_view value = function.distance == "exact"   ? "exact distance"
                                 : function.distance == "bound" ? "never more than the distance"
                                                                : "";
  return fmt::format("{}{}{}", function.meaning, function.meaning.empty() || value.empty() ? "" : " · ", value);
}

const std::vector<Constant>& constants() {
  static const std::vector<Constant> all{
      {"x", "the first coordinate, mm", Expression::x()}, {"y", "the second coordinate, mm", Expression::y()},
      {"z", "the third coordinate, mm", Expression::z()}, {"pi", "3.14159…", std::numbers::pi},
      {"tau", "6.28318…, 2 pi", 2 * std::numbers::pi},    {"e", "2.71828…", std::numbers::e}};
  return all;
}

const Constant* find_constant(std::string_view name) {
  for (const Constant& constant : constants())
    if (constant.name == name) return &constant;
  return nullptr;
}

Expression call(const LibraryFunction& function, const std::vector<std::optional<Expression>>& given,
                std::string_view text) {
  Arguments arguments;
  arguments.text = text;
  for (std::size_t i = 0; i < std::max(given.size(), function.parameters.size()); ++i) {
    const Parameter& parameter = function.parameters[std::min(i, function.parameters.size() - 1)];
    const bool missing = i >= given.size() || !given[i];
    if (missing && !parameter.fallback)
      throw Error(ErrorKind::bad_input, "", fmt::format("'{}' lacks its argument '{}'", function.name, parameter.name));
    const double unit = parameter.quantity == Quantity::angle ? radians_per_degree : 1;
    const Expression value = missing ? Expression(*parameter.fallback * unit) : *given[i];
    const bool is_plain = parameter.quantity == Quantity::number || parameter.quantity == Quantity::whole;
    arguments.values.push_back(is_plain ? plain(value, function, parameter) : value);
  }
  return function.make(arguments);
}

namespace {

Opcode operation(char sign) {
  switch (sign) {
    case '+': return Opcode::add;
    case '-': return Opcode::subtract;
    case '*': return Opcode::multiply;
    case '/': return Opcode::divide;
    case '^': return Opcode::power;
    case '|': return Opcode::minimum;
    default: return Opcode::maximum;
  }
}

Expression folded(char sign, const Expression& a, const Expression& b) {
  switch (sign) {
    case '+': return a + b;
    case '-': return a - b;
    case '*': return a * b;
    case '/': return a / b;
    case '^': return pow(a, b);
    case '|': return min(a, b);
    default: return max(a, b);
  }
}

}  // namespace

Value joined(char sign, const Value& a, const Value& b, Making making) {
  const bool sets = sign == '|' || sign == '&';
  if (a.solid && b.solid && sign == '-') return {shapes::subtract(a.expression, b.expression), true};
  if (a.solid && b.solid && !sets)
    throw Error(
        ErrorKind::bad_input, "",
        fmt::format("'{0}' of two solids: write a | b for their union, or value(a) {0} value(b) for numbers", sign));
  const bool solid = sets || (sign != '^' && (a.solid || b.solid));
  return {making == Making::folded ? folded(sign, a.expression, b.expression)
                                   : Expression::make(operation(sign), a.expression, b.expression),
          solid};
}

Value call(const LibraryFunction& function, std::span<const std::optional<Value>> given, std::string_view text) {
  std::vector<std::optional<Expression>> expressions;
  bool all_solids = true;
  for (const std::optional<Value>& value : given) {
    expressions.push_back(value ? std::optional(value->expression) : std::nullopt);
    all_solids = all_solids && (!value || value->solid);
  }
  bool solid = function.group != "numbers";
  if (function.name == "min" || function.name == "max") solid = all_solids;
  if (function.name == "map") solid = !given.empty() && given.front() && given.front()->solid;
  return {call(function, expressions, text), solid};
}

}  // namespace fieldfab::frep
