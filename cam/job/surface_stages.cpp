// Operations on surfaces.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "fieldfab/cam/plan/tilt.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "stages.h"

namespace fieldfab::cam {
namespace {

using SurfacePtr = std::shared_ptr<const Surface>;

Depths depths_of(const Values& values, const Context& context, const Surface& surface) {
  Depths d;
  d.top = is_set(values, "top") ? values.number("top") : std::max(context.stock.upper.z(), surface.top());
  d.bottom = is_set(values, "bottom") ? values.number("bottom") : surface.floor();
  d.step = is_set(values, "stepdown") ? values.number("stepdown") : std::max(0.1, context.tool.diameter / 2);
  return d;
}

Settings depth_settings() {
  return {number("top", "mm", unset, "z where the cut begins; the default is the stock's top"),
          number("bottom", "mm", unset, "z where the cut ends; the default is the floor of the surface"),
          above_zero(number("stepdown", "mm", unset, "depth of each level; the default is half the tool's diameter"))};
}

CutSettings cut_of(const Values& values, const Context& context) {
  CutSettings cut;
  cut.radius = context.tool.profile().radius();
  cut.climb = values.flag("climb");
  cut.tolerance = values.number("tolerance");
  return cut;
}

double stepover_of(const Values& values, const Context& context) {
  if (values.has("scallop") && is_set(values, "scallop")) {
    const double corner = context.tool.shape == ToolShape::ball ? context.tool.radius() : context.tool.corner_radius;
    if (!(corner > 0))
      throw Error(ErrorKind::bad_input, values.place("scallop"),
                  "a scallop needs a ball, bull-nose or tapered tool; give a stepover");
    return stepover_for_scallop(corner, values.number("scallop"));
  }
  return values.number("stepover") * 2 * context.tool.profile().radius();
}

Artifact rough_stage(const Artifact& in, const Values& values, Context& context) {
  const SurfacePtr& surface = std::get<SurfacePtr>(in);
  RoughSettings settings;
  settings.stock = Rectangle::of(context.stock);
  settings.depths = depths_of(values, context, *surface);
  settings.depths.bottom = std::max(settings.depths.bottom + values.number("allowance"), surface->floor());
  settings.cut = cut_of(values, context);
  settings.clear = clear_of(values, stepover_of(values, context), context.tool);
  settings.clear.material = &context.material;
  settings.cell = std::max(surface->samples().cell, settings.cut.radius / 20);
  const auto tips = std::make_shared<TipSurface>(surface, context.tool.profile(), values.number("allowance"));
  PlannedCuts cuts;
  cuts.paths = rough(tips, settings, context.progress);
  cuts.width = settings.clear.stepover;
  if (settings.clear.adaptive) {
    cuts.ordered = true;
    return cuts;
  }
  cuts.paths = where_material(cuts.paths, context.material, settings.cut.radius);
  const double longest = 2.5 * settings.clear.stepover;
  cuts.may_stay_down = [tips, longest](const Vec3& from, const Vec3& to) {
    const double length = (to - from).norm();
    if (std::abs(from.z() - to.z()) > 1e-6 || length > longest) return false;
    const int steps = 1 + static_cast<int>(length / (0.1 * longest));
    for (int i = 0; i <= steps; ++i)
      if (tips->tip((from + (to - from) * i / steps).head<2>()) > from.z() + 1e-3) return false;
    return true;
  };
  return cuts;
}

FinishSettings finish_of(const Values& values, const Context& context, const Surface& surface) {
  FinishSettings settings;
  settings.area = Rectangle::of(context.stock);
  settings.stepover = stepover_of(values, context);
  settings.tolerance = values.number("tolerance");
  settings.bottom = is_set(values, "bottom") ? values.number("bottom") : surface.floor();
  return settings;
}

/// Joins paths if the tool may move straight from one to the next.
std::vector<Path> joined(const std::vector<Path>& paths,
                         const std::function<bool(const Vec3&, const Vec3&)>& may_go_on) {
  std::vector<Path> out;
  for (const Path& path : paths) {
    if (path.points.empty()) continue;
    Path open = path;
    if (path.closed) open.points.push_back(path.points.front()), open.closed = false;
    open.points.back().bulge = 0;
    if (!out.empty() && may_go_on(out.back().points.back().at, open.points.front().at))
      out.back().points.insert(out.back().points.end(), open.points.begin(), open.points.end());
    else
      out.push_back(std::move(open));
  }
  return out;
}

/// Tilts the tool along the surface, if requested.
void lean(PlannedCuts& cuts, const Values& values, const TipSurface& tips, Context& context) {
  if (!values.flag("lean")) return;
  const Tool& tool = context.tool;
  if (tool.shape != ToolShape::ball && tool.shape != ToolShape::tapered)
    throw Error(ErrorKind::bad_input, values.place("lean"), "only a ball or a tapered ball can lean while it cuts");
  if (context.part == nullptr) throw Error(ErrorKind::bad_input, values.place("lean"), "needs a solid");
  TiltSettings settings;
  settings.lead = values.number("lead") * radians_per_degree;
  settings.most = values.number("most_lean") * radians_per_degree;
  settings.clearance = values.number("body_clearance");
  settings.tolerance = values.number("tolerance");
  TiltReport report;
  cuts.paths = tilted(joined(cuts.paths, cuts.may_stay_down), tips, tool, context.plane, context.space(), settings,
                      report, context.progress);
  cuts.leans = settings.most;
  cuts.may_stay_down = nullptr;
  if (report.otherwise > 1)
    context.notes.push_back(
        fmt::format("the tool leans less than asked for, or elsewhere, along {:.0f} mm: it would touch the part",
                    report.otherwise));
  if (report.left_out > 1)
    context.notes.push_back(
        fmt::format("{:.0f} mm of the paths are left out: shank or holder would touch the part however the tool leans",
                    report.left_out));
}

Settings lean_settings() {
  return {
      flag("lean", false, "five axes at once: the tool tilts with the surface"),
      only_with("lean", between(-45, 45,
                                number("lead", "degrees", 10,
                                       "lead angle: tilt ahead of the surface normal, in the direction of travel"))),
      only_with("lean", between(1, 85, number("most_lean", "degrees", 60, "greatest tilt against the plane's z"))),
      only_with("lean", above_zero(number("body_clearance", "mm", 1, "clearance of shank and holder from the part")))};
}

/// Whether the tool may move straight over the surface to the next pass.
std::function<bool(const Vec3&, const Vec3&)> over(std::shared_ptr<const TipSurface> tips, double longest,
                                                   double tolerance) {
  return [tips = std::move(tips), longest, tolerance](const Vec3& from, const Vec3& to) {
    const double length = (to - from).head<2>().norm();
    if (length > longest) return false;
    const int steps = 1 + static_cast<int>(length / tips->surface().samples().cell * 4);
    for (int i = 0; i <= steps; ++i) {
      const Vec3 p = from + (to - from) * i / steps;
      if (tips->tip(p.head<2>()) > p.z() + tolerance) return false;
    }
    return true;
  };
}

/// Leaves out passes through the air, if requested: over flats that are finished already, and beyond the stock. (On
/// slopes the planned stock is known to a lattice cell only, and passes stay.)
void skip_air(PlannedCuts& cuts, const Values& values, const Surface& surface, const Context& context) {
  // A height map that is higher than its picture's stock says nothing of what is left.
  if (!values.flag("skip_air") || surface.top() > context.stock.upper.z() + values.number("tolerance")) return;
  const std::size_t before = cuts.paths.size();
  cuts.paths = without_air(cuts.paths, context.material, context.tool.profile(), values.number("tolerance"));
  cuts.ordered = cuts.ordered && cuts.paths.size() == before;
}

/// Removes what earlier operations have finished: on other planes, and for rest machining also on
/// this one.
void leave_out_reached(PlannedCuts& cuts, const Values& values, const std::shared_ptr<const TipSurface>& tips,
                       const Context& context) {
  const bool rest = values.flag("rest");
  if (context.part == nullptr) {
    if (rest) throw Error(ErrorKind::bad_input, values.place("rest"), "needs a solid");
    return;
  }
  std::vector<Reached> earlier;
  for (const Reached& reached : context.earlier)
    if (rest || reached.plane().name != context.plane.name) earlier.push_back(reached);
  if (rest && earlier.empty())
    throw Error(ErrorKind::bad_input, values.place("rest"), "no operation before this one finishes the part");
  const std::size_t before = cuts.paths.size();
  cuts.paths = not_reached(cuts.paths, context.plane, *tips, *context.part, earlier,
                           std::max(values.number("tolerance"), values.number("rest_least")));
  cuts.ordered = cuts.ordered && cuts.paths.size() == before && !rest;
  cuts.inside_first = false;
  if (tips->allowance() == 0) cuts.finished = tips;
}

Settings rest_settings() {
  return {flag("rest", false, "rest machining: only where earlier operations left material"),
          only_with("rest", above_zero(number("rest_least", "mm", 0.05, "least height of that material")))};
}

Artifact finish_stage(const Artifact& in, const Values& values, Context& context) {
  const SurfacePtr& surface = std::get<SurfacePtr>(in);
  FinishSettings settings = finish_of(values, context, *surface);
  const auto tips = std::make_shared<TipSurface>(surface, context.tool.profile(), values.number("allowance"));
  const std::string& pattern = values.text("pattern");
  PlannedCuts cuts;
  cuts.ordered = true;
  const auto add = [&](std::vector<Path> paths) { cuts.paths.insert(cuts.paths.end(), paths.begin(), paths.end()); };
  settings.both_ways = values.flag("both_ways");
  settings.angle = values.number("angle") * radians_per_degree;
  if (pattern == "spiral") {
    add(spiral(*tips, settings, context.progress));
  } else {
    add(raster(*tips, settings, context.progress));
    if (pattern == "cross") {
      settings.angle += std::numbers::pi / 2;
      add(raster(*tips, settings, context.progress));
    }
  }
  leave_out_reached(cuts, values, tips, context);
  skip_air(cuts, values, *surface, context);
  cuts.may_reverse = settings.both_ways;
  cuts.width = settings.stepover;
  cuts.may_stay_down = over(tips, 1.5 * settings.stepover, settings.tolerance);
  lean(cuts, values, *tips, context);
  return cuts;
}

Artifact waterline_stage(const Artifact& in, const Values& values, Context& context) {
  const SurfacePtr& surface = std::get<SurfacePtr>(in);
  CutSettings cut = cut_of(values, context);
  cut.depths = depths_of(values, context, *surface);
  const auto tips = std::make_shared<TipSurface>(surface, context.tool.profile(), values.number("allowance"));
  PlannedCuts cuts;
  cuts.paths = waterline(tips, Rectangle::of(context.stock).grown(cut.radius),
                         std::max(surface->samples().cell, cut.radius / 20), cut, context.progress);
  if (values.flag("rest")) leave_out_reached(cuts, values, tips, context), cuts.finished = nullptr;
  lean(cuts, values, *tips, context);
  return cuts;
}

Artifact pencil_stage(const Artifact& in, const Values& values, Context& context) {
  const SurfacePtr& surface = std::get<SurfacePtr>(in);
  FinishSettings settings;
  settings.area = Rectangle::of(context.stock);
  settings.tolerance = values.number("tolerance");
  settings.bottom = is_set(values, "bottom") ? values.number("bottom") : surface->floor();
  const TipSurface tips(surface, context.tool.profile(), values.number("allowance"));
  PlannedCuts cuts;
  const double radius = context.tool.profile().radius();
  cuts.paths = pencil(tips, settings, std::max(surface->samples().cell, radius / 10),
                      values.number("least_angle") * radians_per_degree, context.progress);
  if (cuts.paths.empty())
    throw Error(ErrorKind::bad_input, "pencil", "there are no valleys that this tool touches on both sides");
  cuts.inside_first = false;
  cuts.may_reverse = true;
  return cuts;
}

}  // namespace

std::vector<Stage> surface_stages() {
  const Setting allowance = at_least(0, number("allowance", "mm", 0, "stock allowance left on the part"));
  const Setting climb = flag("climb", true, "climb milling; false: conventional milling");
  const Setting tolerance = above_zero(number("tolerance", "mm", 0.01, "tolerance of the path against the surface"));
  const Setting scallop =
      above_zero(number("scallop", "mm", unset, "height of the cusps between passes, instead of a stepover"));
  const auto stepover = [](double standard) {
    Setting s = number("stepover", "diameters", standard, "distance of the passes");
    s.lower = 0, s.lower_open = true, s.upper = 1;
    return s;
  };
  return {
      {"rough", "clears the material above the part level by level", Kind::surface, Kind::paths, true,
       Settings{stepover(0.4), at_least(0, number("allowance", "mm", 0.3, "stock allowance left on the part")), climb,
                tolerance} +
           clear_settings() + depth_settings(),
       rough_stage},
      {"finish", "parallel passes over the part's surface", Kind::surface, Kind::paths, true,
       Settings{
           choice("pattern", {"raster", "cross", "spiral"}, "pattern of the passes"),
           only_with("pattern", number("angle", "degrees", 0, "angle of the passes against x"), {"raster", "cross"}),
           stepover(0.1), scallop, flag("both_ways", true, "zigzag: every other pass runs back"),
           number("bottom", "mm", unset, "lowest z of the tool; the default is the floor of the surface"), allowance,
           tolerance, flag("skip_air", true, "leaves out passes where earlier operations left no stock")} +
           rest_settings() + lean_settings(),
       finish_stage},
      {"waterline", "level contours of the part's surface", Kind::surface, Kind::paths, true,
       Settings{allowance, climb, tolerance} + depth_settings() + rest_settings() + lean_settings(), waterline_stage},
      {"pencil",
       "along the valleys of the part's surface, where a round tool touches both sides",
       Kind::surface,
       Kind::paths,
       true,
       {between(5, 120, number("least_angle", "degrees", 20, "least angle between the two sides")),
        number("bottom", "mm", unset, "lowest z of the tool; the default is the floor of the surface"), allowance,
        tolerance},
       pencil_stage},
  };
}

}  // namespace fieldfab::cam
