// Operations on a surface: roughing in levels, raster, spiral and waterline finishing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "follower.h"

namespace fieldfab::cam {

double stepover_for_scallop(double corner_radius, double scallop) {
  if (!(scallop > 0) || !(scallop < corner_radius))
    throw Error(ErrorKind::bad_input, "scallop",
                fmt::format("must be above 0 and below the tool's corner radius of {:.6g} mm", corner_radius));
  return 2 * std::sqrt(scallop * (2 * corner_radius - scallop));
}

namespace {

Path path_through(const std::vector<Vec3>& points) {
  Path path;
  for (const Vec3& p : points) path.points.push_back({p});
  return path;
}

void check(const FinishSettings& settings) {
  if (!(settings.stepover > 0)) throw Error(ErrorKind::bad_input, "stepover", "must be above 0");
  if (!(settings.tolerance > 0)) throw Error(ErrorKind::bad_input, "tolerance", "must be above 0");
}

}  // namespace

std::vector<Path> raster(const TipSurface& tips, const FinishSettings& settings, Progress& progress) {
  check(settings);
  // In coordinates along and across the passes.
  const Vec2 along(std::cos(settings.angle), std::sin(settings.angle)), across(-along.y(), along.x());
  const Rectangle& r = settings.area;
  Rectangle turned = Rectangle::nothing();
  for (const Vec2& corner : {r.lower, r.upper, Vec2(r.lower.x(), r.upper.y()), Vec2(r.upper.x(), r.lower.y())})
    turned.add({along.dot(corner), across.dot(corner)});
  const int passes = 1 + std::max(1, static_cast<int>(std::ceil(turned.size().y() / settings.stepover - 1e-9)));
  const double cell = tips.surface().samples().cell;
  std::vector<Path> paths(static_cast<std::size_t>(passes));
  parallel_for(paths.size(), [&](std::size_t pass) {
    progress.check();
    // Part of the pass's line within the rectangle.
    const double v = turned.lower.y() + turned.size().y() * static_cast<double>(pass) / (passes - 1);
    double first = turned.lower.x(), last = turned.upper.x();
    for (int axis = 0; axis < 2; ++axis) {
      const double slope = along[axis], start = v * across[axis];
      if (std::abs(slope) < 1e-12) continue;
      const double a = (r.lower[axis] - start) / slope, b = (r.upper[axis] - start) / slope;
      first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
    }
    if (last < first) return;
    const int steps = std::max(1, static_cast<int>(std::ceil((last - first) / cell)));
    Follower follower(tips, settings.bottom, settings.tolerance);
    for (int i = 0; i <= steps; ++i) follower.go((first + (last - first) * i / steps) * along + v * across);
    paths[pass] = path_through(follower.take());
    if (settings.both_ways && pass % 2 == 1) reverse(paths[pass]);
    progress.report(static_cast<double>(pass) / passes, "finishing");
  });
  std::erase_if(paths, [](const Path& p) { return p.points.size() < 2; });
  return paths;
}

std::vector<Path> spiral(const TipSurface& tips, const FinishSettings& settings, Progress& progress) {
  check(settings);
  const Vec2 centre = 0.5 * (settings.area.lower + settings.area.upper);
  const double furthest = 0.5 * settings.area.size().norm(), cell = tips.surface().samples().cell;
  std::vector<Path> paths;
  Follower follower(tips, settings.bottom, settings.tolerance);
  bool going = false;
  const auto finish = [&] {
    if (going) paths.push_back(path_through(follower.take()));
    going = false;
  };
  double angle = 0;
  for (double radius = 0; radius <= furthest;) {
    const Vec2 p = centre + radius * Vec2(std::cos(angle), std::sin(angle));
    if (settings.area.contains(p))
      follower.go(p), going = true;
    else
      finish();
    angle += cell / std::max(radius, cell);
    radius = settings.stepover * angle / (2 * std::numbers::pi);
    progress.check();
    progress.report(radius / furthest, "finishing");
  }
  finish();
  std::erase_if(paths, [](const Path& p) { return p.points.size() < 2; });
  return paths;
}

std::vector<Path> waterline(const std::shared_ptr<const TipSurface>& tips, const Rectangle& area, double cell,
                            const CutSettings& cut, Progress& progress) {
  const FieldPtr field = TipSurface::field(tips);
  const std::vector<double> passes = cut.depths.passes();
  std::vector<Path> paths;
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    progress.report(static_cast<double>(pass) / static_cast<double>(passes.size()), "waterlines");
    for (const Loop& loop : contours(*field, area, {cell, 0, -passes[pass]}, progress)) {
      Path path = cut.arcs ? fit_arcs(loop.points, true, passes[pass], cut.tolerance) : Path{};
      if (!cut.arcs) {
        for (const Vec2& p : loop.points) path.points.push_back({{p.x(), p.y(), passes[pass]}});
        path.closed = true;
      }
      if (cut.climb) reverse(path);
      path.level = static_cast<int>(pass);
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

std::vector<Path> rough(const std::shared_ptr<const TipSurface>& tips, const RoughSettings& settings,
                        Progress& progress) {
  const FieldPtr blocked = TipSurface::field(tips);
  // The tool's centre may leave the stock by its radius, so that no material remains at the border;
  // farther for adaptive clearing, to start there.
  const Rectangle reach = settings.stock.grown((settings.clear.adaptive ? 1.5 : 1) * settings.cut.radius);
  const std::vector<double> passes = settings.depths.passes();
  std::vector<Path> paths;
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    progress.report(static_cast<double>(pass) / static_cast<double>(passes.size()), "roughing");
    Loops walls = contours(*blocked, reach.grown(2 * settings.cell), {settings.cell, 0, -passes[pass]}, progress);
    // Distance to the walls and to the border of the reachable area: negative for permitted
    // centres.
    const Vec2 a = reach.lower, b = reach.upper;
    FieldPtr free = outline_field({{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}}});
    if (!walls.empty()) free = intersect(free, complement(outline_field(walls)));
    CutSettings level = settings.cut;
    level.depths = {pass == 0 ? settings.depths.top : passes[pass - 1], passes[pass]};
    const Rectangle bounds = reach.grown(settings.cell);
    std::vector<Path> cleared =
        settings.clear.adaptive
            ? adaptive(*free, bounds, settings.cell, settings.clear, level, progress)
            : rings(*free, bounds, settings.cell, settings.clear.stepover, passes[pass], settings.cut, progress);
    for (Path& path : cleared) {
      path.level = static_cast<int>(pass);
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

}  // namespace fieldfab::cam
