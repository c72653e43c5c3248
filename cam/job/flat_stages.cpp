// Operations on outlines.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "stages.h"

namespace fieldfab::cam {
namespace {

Depths depths_of(const Values& values, const Box& stock) {
  Depths d;
  d.top = is_set(values, "top") ? values.number("top") : stock.upper.z();
  d.bottom = is_set(values, "depth") ? d.top - values.number("depth") : stock.lower.z();
  if (is_set(values, "stepdown")) d.step = values.number("stepdown");
  if (!(d.bottom < d.top))
    throw Error(ErrorKind::bad_input, values.place("depth"), "give a depth, or a stock with a thickness");
  return d;
}

Settings flat_depth_settings(double standard_depth = unset) {
  return {number("top", "mm", unset, "z of the top of the material; the default is the top of the stock"),
          above_zero(number("depth", "mm", standard_depth, "depth below the top; the default is through the stock")),
          above_zero(number("stepdown", "mm", unset, "depth of each pass; the default is one pass"))};
}

Settings cut_settings() {
  return {at_least(0, number("allowance", "mm", 0, "stock allowance left on the part")),
          flag("climb", true, "climb milling; false: conventional milling"),
          above_zero(number("tolerance", "mm", 0.005, "tolerance of fitting lines and arcs"))};
}

CutSettings cut_of(const Values& values, const Context& context, const Depths& depths) {
  CutSettings cut;
  cut.radius = context.tool.diameter / 2;
  cut.allowance = values.number("allowance");
  cut.climb = values.flag("climb");
  cut.tolerance = values.number("tolerance");
  cut.depths = depths;
  return cut;
}

double flat_stepover_of(const Values& values, const Context& context) {
  if (!(context.tool.diameter > 0))
    throw Error(ErrorKind::bad_input, values.place("stepover"), "needs a tool with a diameter");
  return values.number("stepover") * context.tool.diameter;
}

Setting stepover_setting(double standard, const std::string& of) {
  Setting s = number("stepover", "diameters", standard, of);
  s.lower = 0, s.lower_open = true, s.upper = 1;
  return s;
}

Side side_of(const Values& values) {
  const std::string& side = values.text("side");
  return side == "outside" ? Side::outside : side == "inside" ? Side::inside : Side::on;
}

Artifact profile_stage(const Artifact& in, const Values& values, Context& context) {
  const Tabs tabs{static_cast<int>(values.number("tabs")), values.number("tab_width"), values.number("tab_height")};
  PlannedCuts cuts;
  cuts.paths = profile(std::get<Outline>(in), side_of(values),
                       cut_of(values, context, depths_of(values, context.stock)), tabs, context.progress);
  return cuts;
}

Artifact isolate_stage(const Artifact& in, const Values& values, Context& context) {
  PlannedCuts cuts;
  cuts.paths =
      isolate(std::get<Outline>(in), static_cast<int>(values.number("offsets")), flat_stepover_of(values, context),
              cut_of(values, context, depths_of(values, context.stock)), context.progress);
  cuts.inside_first = false;  // no piece comes loose
  return cuts;
}

/// Whether a straight line between neighbouring rings stays within permitted tool centres.
std::function<bool(const Vec3&, const Vec3&)> within(FieldPtr distance, double clear, double longest) {
  return [distance = std::move(distance), clear, longest](const Vec3& from, const Vec3& to) {
    if (std::abs(from.z() - to.z()) > 1e-6) return false;
    const double length = (to - from).norm();
    if (length > longest) return false;
    const int steps = 1 + static_cast<int>(length / (0.1 * longest));
    for (int i = 0; i <= steps; ++i) {
      const Vec3 p = from + (to - from) * i / steps;
      if (distance->value({p.x(), p.y(), 0}) > -clear + 1e-3) return false;
    }
    return true;
  };
}

/// The side of an outline that is cut; its outside is the stock around the part, which the tool may leave.
Outline area_of(const Artifact& in, const Values& values, const CutSettings& cut, const Context& context) {
  Outline area = std::get<Outline>(in);
  if (values.text("side") == "outside") {
    const Rectangle stock = Rectangle::of(context.stock).grown(cut.radius);
    const Vec2 a = stock.lower, b = stock.upper;
    area.distance = intersect(complement(area.distance), outline_field({{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}}}));
    area.bounds = stock;
  }
  return area;
}

Artifact pocket_stage(const Artifact& in, const Values& values, Context& context) {
  const CutSettings cut = cut_of(values, context, depths_of(values, context.stock));
  const Outline area = area_of(in, values, cut, context);
  const ClearSettings clear = clear_of(values, flat_stepover_of(values, context), context.tool);
  const std::vector<Vec2> left = too_narrow(area, cut.radius + cut.allowance, context.progress);
  PlannedCuts cuts;
  cuts.paths = pocket(area, clear, cut, context.progress);
  cuts.ordered = clear.adaptive;
  cuts.width = clear.stepover;
  for (const Vec2& place : left)
    context.notes.push_back(
        fmt::format("the tool of {:.4g} mm is too large for the pocket around x {:.2f}, y {:.2f}: it is left",
                    2 * cut.radius, place.x(), place.y()));
  if (cuts.paths.empty())
    throw Error(ErrorKind::bad_input, "pocket",
                left.empty()
                    ? "there is nothing to clear"
                    : fmt::format("the tool of {:.4g} mm fits into no pocket; the first is around x {:.2f}, y {:.2f}",
                                  2 * cut.radius, left[0].x(), left[0].y()));
  if (!clear.adaptive) cuts.may_stay_down = within(area.distance, cut.radius + cut.allowance, 2.5 * clear.stepover);
  return cuts;
}

Artifact slot_stage(const Artifact& in, const Values& values, Context& context) {
  const CutSettings cut = cut_of(values, context, depths_of(values, context.stock));
  const Outline area = area_of(in, values, cut, context);
  const double widest = is_set(values, "widest") ? values.number("widest") : 1.05 * context.tool.diameter;
  const Loops loops = contours(*area.distance, area.bounds, {area.cell}, context.progress);
  Slots found = slots(loops, widest, cut, context.progress);
  if (found.paths.empty())
    throw Error(ErrorKind::bad_input, "slot",
                fmt::format("no slot is between {:.4g} and {:.4g} mm wide", 2 * (cut.radius + cut.allowance), widest));
  for (const Vec2& place : found.wide)
    context.notes.push_back(
        fmt::format("the slot around x {:.2f}, y {:.2f} is wider than the tool of {:.4g} mm: its sides keep material",
                    place.x(), place.y(), 2 * cut.radius));
  PlannedCuts cuts;
  cuts.paths = std::move(found.paths);
  cuts.inside_first = false;
  return cuts;
}

/// Holes of the part's outline up to a diameter, mm. Throws Error(bad_input) with the operation's name if there are
/// none.
std::vector<Hole> holes_of(const Artifact& in, double most, const char* operation, Context& context) {
  const Outline& outline = std::get<Outline>(in);
  Loops loops = contours(*outline.distance, outline.bounds, {outline.cell}, context.progress);
  std::erase_if(loops, [](const Loop& loop) { return loop.area() > 0; });
  std::vector<Hole> found = holes(loops, 2 * outline.cell * 0.1 + 0.02);
  std::erase_if(found, [&](const Hole& h) { return 2 * h.radius > most; });
  if (found.empty())
    throw Error(ErrorKind::bad_input, operation, fmt::format("the part has no round holes of at most {:.4g} mm", most));
  return found;
}

Artifact drill_stage(const Artifact& in, const Values& values, Context& context) {
  const double most = is_set(values, "largest") ? values.number("largest") : context.tool.diameter * 1.05;
  PlannedCuts cuts;
  cuts.drills = true;
  cuts.paths = drill(holes_of(in, most, "drill", context), is_set(values, "peck") ? values.number("peck") : 0,
                     depths_of(values, context.stock));
  return cuts;
}

Artifact thread_stage(const Artifact& in, const Values& values, Context& context) {
  ThreadSettings thread;
  if (!is_set(values, "pitch")) throw Error(ErrorKind::bad_input, values.place("pitch"), "a thread needs its pitch");
  thread.pitch = values.number("pitch");
  if (is_set(values, "diameter")) thread.diameter = values.number("diameter");
  thread.right_hand = values.text("hand") == "right";
  thread.passes = static_cast<int>(values.number("passes"));
  CutSettings cut = cut_of(values, context, depths_of(values, context.stock));
  // Of a thread with a diameter: the holes that are as wide as its tips, within a quarter of the pitch.
  const double hole = thread.diameter - 2 * thread_depth(thread.pitch);
  std::vector<Hole> where = holes_of(in, thread.diameter > 0 ? hole + thread.pitch / 4 : 1e6, "thread", context);
  if (thread.diameter > 0) std::erase_if(where, [&](const Hole& h) { return 2 * h.radius < hole - thread.pitch / 4; });
  if (where.empty())
    throw Error(ErrorKind::bad_input, "thread",
                fmt::format("the part has no holes for this thread; it wants {:.4g} mm", hole));
  PlannedCuts cuts;
  cuts.paths = mill_threads(where, thread, cut);
  cuts.ordered = true;
  return cuts;
}

Artifact face_stage(const Artifact& in, const Values& values, Context& context) {
  const Solid& solid = std::get<Solid>(in);
  Depths depths;
  depths.top = is_set(values, "top") ? values.number("top") : context.stock.upper.z();
  if (is_set(values, "depth"))
    depths.bottom = depths.top - values.number("depth");
  else if (solid.flat)
    throw Error(ErrorKind::bad_input, values.place("depth"), "the part is flat: give the depth to face");
  else
    depths.bottom = tight_bounds(*solid.field, *solid.bounds, context.progress).upper.z() + values.number("allowance");
  if (!(depths.bottom < depths.top - 1e-9))
    throw Error(ErrorKind::bad_input, values.place("depth"),
                "the stock is no higher than the part: there is nothing to face; give a depth");
  if (is_set(values, "stepdown")) depths.step = values.number("stepdown");
  const FaceSettings settings{flat_stepover_of(values, context), to_radians(values.number("angle")),
                              values.flag("both_ways")};
  PlannedCuts cuts;
  cuts.paths = face(Rectangle::of(context.stock), settings, cut_of(values, context, depths));
  cuts.ordered = true;
  cuts.width = settings.stepover;
  return cuts;
}

/// Height of the part's highest point seen from the plane, mm; the stock's top for a drawing or a picture.
double top_of_part(const Context& context) {
  if (context.part == nullptr) return context.stock.upper.z();
  Eigen::Affine3d into = Eigen::Affine3d::Identity();
  into.linear() = context.plane.axes.transpose();
  into.translation() = -context.plane.origin;
  return tight_bounds(*transform(context.part, into), context.stock, context.progress).upper.z();
}

/// The flank of a V passes through the outline `width` inside of it at the top, while its axis runs `beyond` mm
/// outside.
Artifact chamfer_stage(const Artifact& in, const Values& values, Context& context) {
  if (context.tool.shape != ToolShape::v) throw Error(ErrorKind::bad_input, "chamfer", "needs a tool of shape v");
  const double width = values.number("width"), beyond = values.number("beyond"), wide = context.tool.diameter / 2;
  if (width + beyond > wide)
    throw Error(
        ErrorKind::bad_input, values.place("width"),
        fmt::format("width and beyond are {:.4g} mm together; the tool's radius is {:.4g} mm", width + beyond, wide));
  Depths depths;
  depths.top = is_set(values, "top") ? values.number("top") : top_of_part(context);
  depths.bottom = depths.top - (width + beyond) / std::tan(context.tool.angle / 2);
  CutSettings cut = cut_of(values, context, depths);
  cut.radius = beyond;
  PlannedCuts cuts;
  cuts.paths = profile(std::get<Outline>(in), side_of(values), cut, {}, context.progress);
  cuts.inside_first = false;
  if (cuts.paths.empty())
    throw Error(ErrorKind::bad_input, "chamfer", "the part has no outline on this side that the tool can follow");
  return cuts;
}

Artifact engrave_stage(const Artifact& in, const Values& values, Context& context) {
  PlannedCuts cuts;
  cuts.paths = profile(std::get<Outline>(in), Side::on, cut_of(values, context, depths_of(values, context.stock)), {},
                       context.progress);
  cuts.inside_first = false;
  return cuts;
}

Artifact v_carve_stage(const Artifact& in, const Values& values, Context& context) {
  if (context.tool.shape != ToolShape::v) throw Error(ErrorKind::bad_input, "v_carve", "needs a tool of shape v");
  const Outline& outline = std::get<Outline>(in);
  const Loops loops = contours(*outline.distance, outline.bounds, {outline.cell}, context.progress);
  Depths depths = depths_of(values, context.stock);
  // The depth is limited by the tool's radius.
  depths.bottom = std::max(depths.bottom, depths.top - 0.5 * context.tool.diameter / std::tan(context.tool.angle / 2));
  PlannedCuts cuts;
  cuts.paths = v_carve(loops, context.tool.angle / 2, values.number("stepover"), cut_of(values, context, depths),
                       context.progress);
  cuts.inside_first = false;
  cuts.may_reverse = true;
  return cuts;
}

/// The part of an area at and above its depth.
FieldPtr over_depth(FieldPtr area, const Values& values, const Box& stock) {
  const double beyond = 10;  // so that no face coincides with one of the stock
  Box reach = stock.grown(beyond);
  if (const double bottom = depths_of(values, stock).bottom; bottom > stock.lower.z()) reach.lower.z() = bottom;
  return intersect(std::move(area), box_field(reach));
}
FieldPtr inside(const FieldPtr& drawing, const Values& values, const Box& stock) {
  return over_depth(drawing, values, stock);
}
FieldPtr outside(const FieldPtr& drawing, const Values& values, const Box& stock) {
  return over_depth(complement(drawing), values, stock);
}
FieldPtr whole_top(const FieldPtr&, const Values& values, const Box& stock) {
  return over_depth(box_field(stock.grown(20)), values, stock);
}
FieldPtr at_side(const FieldPtr& drawing, const Values& values, const Box& stock) {
  const std::string& side = values.text("side");
  return side == "outside"  ? outside(drawing, values, stock)
         : side == "inside" ? inside(drawing, values, stock)
                            : nullptr;
}

}  // namespace

std::vector<Stage> flat_stages() {
  const Settings cut = cut_settings();
  return {
      {"profile", "contour cut along the part's outline", Kind::outline, Kind::paths, true,
       Settings{choice("side", {"outside", "inside", "on"}, "side of the outline on which the tool runs"),
                whole(at_least(0, number("tabs", "", 0, "number of tabs on each outline, which hold the part"))),
                only_with("tabs", above_zero(number("tab_width", "mm", 4, "width of a tab"))),
                only_with("tabs", above_zero(number("tab_height", "mm", 1, "height of a tab")))} +
           flat_depth_settings() + cut,
       profile_stage, at_side},
      {"isolate", "offsets outward from the part, as for the traces of a circuit board", Kind::outline, Kind::paths,
       true,
       Settings{whole(at_least(-1, number("offsets", "", 4, "number of offsets; -1 clears everything"))),
                stepover_setting(0.5, "distance from one offset to the next")} +
           flat_depth_settings(0.1) + cut,
       isolate_stage, outside},
      {"pocket", "clears the inside of the part's outline, or the stock around it", Kind::outline, Kind::paths, true,
       Settings{choice("side", {"inside", "outside"}, "side of the outline that is cleared"),
                stepover_setting(0.4, "distance of the rings")} +
           clear_settings() + flat_depth_settings() + cut,
       pocket_stage, at_side},
      {"slot", "runs along the middle of slots as wide as the tool", Kind::outline, Kind::paths, true,
       Settings{choice("side", {"outside", "inside"}, "slots in the part, or the inside of a drawing of slots"),
                above_zero(number("widest", "mm", unset, "greatest width of a slot; the default is 1.05 diameters"))} +
           flat_depth_settings() + cut,
       slot_stage, at_side},
      {"drill", "the part's round holes", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("peck", "mm", unset, "depth of each peck; the default is no pecking")),
                above_zero(
                    number("largest", "mm", unset, "largest diameter of the holes; the default is that of the tool"))} +
           flat_depth_settings(),
       drill_stage, inside},
      {"thread", "mills threads into the part's round holes", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("pitch", "mm", unset, "rise of the thread in a turn")),
                above_zero(number("diameter", "mm", unset,
                                  "largest diameter of the thread, as 6 of M6; the default is that of an ISO thread in "
                                  "each hole")),
                choice("hand", {"right", "left"}, "a right-hand or a left-hand thread"),
                whole(at_least(1, number("passes", "", 1, "number of passes to the thread's full depth")))} +
           flat_depth_settings() + cut,
       thread_stage, inside},
      {"face", "clears the top of the stock, down to the part", Kind::solid, Kind::paths, true,
       Settings{stepover_setting(0.6, "greatest width of a pass"),
                number("angle", "degrees", 0, "angle of the passes to x"),
                flag("both_ways", true, "alternate passes run backwards")} +
           Settings{number("top", "mm", unset, "z of the top of the material; the default is the top of the stock"),
                    above_zero(number("depth", "mm", unset, "depth below the top; the default is down to the part")),
                    above_zero(number("stepdown", "mm", unset, "depth of each pass; the default is one pass"))} +
           cut,
       face_stage, whole_top},
      {"chamfer", "breaks the edges of the part's outline with a V", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("width", "mm", 0.5, "width of the chamfer, seen from above")),
                choice("side", {"outside", "inside"}, "side of the outline on which the tool runs"),
                at_least(0, number("beyond", "mm", 0.5, "distance of the tool's axis from the edge")),
                number("top", "mm", unset, "z of the edge; the default is the top of the part")} +
           cut,
       chamfer_stage},
      {"engrave", "follows the part's outline with the tip, as for lettering", Kind::outline, Kind::paths, true,
       flat_depth_settings(0.2) + cut, engrave_stage},
      {"v_carve", "carves the inside of the outline with a V", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("stepover", "mm", 0.2, "distance of passes on a flat floor"))} +
           flat_depth_settings() + cut,
       v_carve_stage, inside},
  };
}

}  // namespace fieldfab::cam
