// Operations on outlines.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
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

Settings depth_settings(double standard_depth = unset) {
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

double stepover_of(const Values& values, const Context& context) {
  if (!(context.tool.diameter > 0))
    throw Error(ErrorKind::bad_input, values.place("stepover"), "needs a tool with a diameter");
  return values.number("stepover") * context.tool.diameter;
}

Setting stepover_setting(double standard, const std::string& of) {
  Setting s = number("stepover", "diameters", standard, of);
  s.lower = 0, s.lower_open = true, s.upper = 1;
  return s;
}

Artifact profile_stage(const Artifact& in, const Values& values, Context& context) {
  const std::string& side = values.text("side");
  const Tabs tabs{static_cast<int>(values.number("tabs")), values.number("tab_width"), values.number("tab_height")};
  PlannedCuts cuts;
  cuts.paths = profile(std::get<Outline>(in),
                       side == "outside"  ? Side::outside
                       : side == "inside" ? Side::inside
                                          : Side::on,
                       cut_of(values, context, depths_of(values, context.stock)), tabs, context.progress);
  return cuts;
}

Artifact isolate_stage(const Artifact& in, const Values& values, Context& context) {
  PlannedCuts cuts;
  cuts.paths = isolate(std::get<Outline>(in), static_cast<int>(values.number("offsets")), stepover_of(values, context),
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

Artifact pocket_stage(const Artifact& in, const Values& values, Context& context) {
  Outline area = std::get<Outline>(in);
  const CutSettings cut = cut_of(values, context, depths_of(values, context.stock));
  if (values.text("side") == "outside") {
    // The stock around the part.
    const Rectangle stock = Rectangle::of(context.stock).grown(cut.radius);
    const Vec2 a = stock.lower, b = stock.upper;
    area.distance = intersect(complement(area.distance), outline_field({{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}}}));
    area.bounds = stock;
  }
  const ClearSettings clear = clear_of(values, stepover_of(values, context), context.tool);
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

Artifact drill_stage(const Artifact& in, const Values& values, Context& context) {
  const Outline& outline = std::get<Outline>(in);
  const double most = is_set(values, "largest") ? values.number("largest") : context.tool.diameter * 1.05;
  Loops loops = contours(*outline.distance, outline.bounds, {outline.cell}, context.progress);
  std::erase_if(loops, [](const Loop& loop) { return loop.area() > 0; });
  std::vector<Hole> found = holes(loops, 2 * outline.cell * 0.1 + 0.02);
  std::erase_if(found, [&](const Hole& h) { return 2 * h.radius > most; });
  if (found.empty())
    throw Error(ErrorKind::bad_input, "drill", fmt::format("the part has no round holes of at most {:.4g} mm", most));
  PlannedCuts cuts;
  cuts.paths = drill(found, is_set(values, "peck") ? values.number("peck") : 0, depths_of(values, context.stock));
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
           depth_settings() + cut,
       profile_stage, at_side},
      {"isolate", "offsets outward from the part, as for the traces of a circuit board", Kind::outline, Kind::paths,
       true,
       Settings{whole(at_least(-1, number("offsets", "", 4, "number of offsets; -1 clears everything"))),
                stepover_setting(0.5, "distance from one offset to the next")} +
           depth_settings(0.1) + cut,
       isolate_stage, outside},
      {"pocket", "clears the inside of the part's outline, or the stock around it", Kind::outline, Kind::paths, true,
       Settings{choice("side", {"inside", "outside"}, "side of the outline that is cleared"),
                stepover_setting(0.4, "distance of the rings")} +
           clear_settings() + depth_settings() + cut,
       pocket_stage, at_side},
      {"drill", "the part's round holes", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("peck", "mm", unset, "depth of each peck; the default is no pecking")),
                above_zero(
                    number("largest", "mm", unset, "largest diameter of the holes; the default is that of the tool"))} +
           depth_settings(),
       drill_stage, inside},
      {"v_carve", "carves the inside of the outline with a V", Kind::outline, Kind::paths, true,
       Settings{above_zero(number("stepover", "mm", 0.2, "distance of passes on a flat floor"))} + depth_settings() +
           cut,
       v_carve_stage, inside},
  };
}

}  // namespace fieldfab::cam
