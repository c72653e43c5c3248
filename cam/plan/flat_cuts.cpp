// Operations on outlines: profile, isolation, pocket, drilling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "loop_path.h"

namespace fieldfab::cam {

std::vector<double> Depths::passes() const {
  if (!(bottom < top))
    throw Error(ErrorKind::bad_input, "depth",
                fmt::format("the bottom of the cut ({:.6g}) must be below its top ({:.6g})", bottom, top));
  if (!(step > 0)) throw Error(ErrorKind::bad_input, "stepdown", "must be above 0");
  const double depth = top - bottom;
  const int count = std::max(1, static_cast<int>(std::ceil(depth / step - 1e-9)));
  std::vector<double> z;
  for (int i = 1; i <= count; ++i) z.push_back(i == count ? bottom : top - depth * i / count);
  return z;
}

Path loop_path(const Loop& loop, double z, const CutSettings& cut, bool wall_on_left) {
  Path path;
  if (cut.arcs) {
    path = fit_arcs(loop.points, true, z, cut.tolerance);
  } else {
    std::vector<Vec3> points;
    for (const Vec2& p : loop.points) points.emplace_back(p.x(), p.y(), z);
    points.push_back(points.front());
    for (const Vec3& p : simplified(points, cut.tolerance)) path.points.push_back({p});
    path.points.pop_back();
    path.closed = true;
  }
  if (wall_on_left == cut.climb) reverse(path);
  return path;
}

namespace {

/// Copies of the paths at the height of each pass, one level per pass.
std::vector<Path> at_passes(const std::vector<Path>& once, const std::vector<double>& passes) {
  std::vector<Path> paths;
  for (std::size_t pass = 0; pass < passes.size(); ++pass)
    for (Path path : once) {
      for (PathPoint& p : path.points) p.at.z() = passes[pass];
      path.level = static_cast<int>(pass);
      paths.push_back(std::move(path));
    }
  return paths;
}

/// Part of a path between two arc lengths; a closed path wraps round.
Path part_of(const Path& path, double from, double to) {
  Path out;
  double done = 0;
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; done < to; ++i) {
    if (!path.closed && i + 1 >= n) break;
    const PathPoint &a = path.points[i % n], &b = path.points[(i + 1) % n];
    const double length = length_between(a.at, b.at, a.bulge);
    const double first = std::max(0.0, from - done), last = std::min(length, to - done);
    if (length > 0 && last > first) {
      const auto at = [&](double along) { return place_between(a.at, b.at, a.bulge, along / length); };
      PathPoint start = a;
      start.at = at(first);
      start.bulge = std::tan(std::atan(a.bulge) * (last - first) / length);
      if (out.points.empty())
        out.points.push_back(start);
      else
        out.points.back().bulge = start.bulge;
      out.points.push_back({at(last), 0, b.axis});
    }
    done += length;
  }
  return out;
}

/// Raises a closed path over evenly spaced tabs, with vertical steps at both ends.
Path with_tabs(const Path& path, const Tabs& tabs, double tab_top, double tool_radius) {
  const double length = path.length(), wide = tabs.width + 2 * tool_radius;
  const int count = std::min(tabs.count, static_cast<int>(length / (2 * wide)));
  if (count < 1) return path;
  Path out;
  const double z = path.points.front().at.z();
  for (int i = 0; i < count; ++i) {
    const double from = length * i / count, to = length * (i + 1) / count, tab = to - wide;
    const Path low = part_of(path, from, tab), high = part_of(path, tab, to);
    const auto add = [&](const Path& piece, double height) {
      for (PathPoint p : piece.points) {
        p.at.z() = height;
        if (!out.points.empty() && (out.points.back().at - p.at).norm() < 1e-9)
          out.points.back() = p;
        else
          out.points.push_back(p);
      }
    };
    add(low, z), add(high, tab_top);
  }
  out.points.push_back(out.points.front());  // down again at the start
  out.level = path.level;
  return out;
}

}  // namespace

std::vector<Path> profile(const Outline& part, Side side, const CutSettings& cut, const Tabs& tabs,
                          Progress& progress) {
  const double off = side == Side::on ? 0 : cut.radius + cut.allowance;
  const double level = side == Side::inside ? -off : off;
  const Loops loops = contours(*part.distance, part.bounds.grown(std::max(0.0, level) + 2 * part.cell),
                               {part.cell, 0, level}, progress);
  std::vector<Path> once;
  for (const Loop& loop : loops) once.push_back(loop_path(loop, 0, cut, side != Side::inside));
  std::vector<Path> paths = at_passes(once, cut.depths.passes());
  const double tab_top = cut.depths.bottom + tabs.height;
  for (Path& path : paths)
    if (tabs.count > 0 && !path.points.empty() && path.points.front().at.z() < tab_top - 1e-9)
      path = with_tabs(path, tabs, tab_top, cut.radius);
  return paths;
}

std::vector<Path> isolate(const Outline& part, int count, double stepover, const CutSettings& cut, Progress& progress) {
  if (count != 1 && !(stepover > 0)) throw Error(ErrorKind::bad_input, "stepover", "must be above 0");
  std::vector<Path> once;
  for (int ring = 0; count < 0 || ring < count; ++ring) {
    const double level = cut.radius + cut.allowance + ring * stepover;
    // Until the offset has left the bounds: then only the bounds' own outline remains.
    const Loops loops = contours(*part.distance, count < 0 ? part.bounds : part.bounds.grown(level + 2 * part.cell),
                                 {part.cell, 0, level}, progress);
    const bool filled = loops.size() == 1 && loops[0].area() >= (1 - 1e-9) * part.bounds.size().prod();
    if (loops.empty() || (count < 0 && filled)) break;
    for (const Loop& loop : loops) once.push_back(loop_path(loop, 0, cut, true));
  }
  return at_passes(once, cut.depths.passes());
}

std::vector<Path> rings(const Field& area, const Rectangle& bounds, double cell, double stepover, double z,
                        const CutSettings& cut, Progress& progress) {
  if (!(stepover > 0)) throw Error(ErrorKind::bad_input, "stepover", "must be above 0");
  std::vector<Path> paths;
  const auto add = [&](const Loops& loops) {
    for (const Loop& loop : loops) paths.push_back(loop_path(loop, z, cut, false));
  };
  Loops ring = contours(area, bounds, {cell}, progress);
  for (int count = 1; !ring.empty(); ++count) {
    add(ring);
    Loops next = contours(area, bounds, {cell, 0, -count * stepover}, progress);
    if (stepover > cut.radius) {
      // If the rings are more than a radius apart, slivers remain between them, in corners and in
      // the middle: the area beyond the reach of the outer ring and outside of that of the inner
      // ring. The tool follows their outlines.
      FieldPtr sliver = offset(area.shared_from_this(), -((count - 1) * stepover + cut.radius));
      if (!next.empty()) sliver = intersect(sliver, complement(offset(outline_field(next), cut.radius)));
      add(contours(*sliver, bounds, {cell, 0, 0.02 * cut.radius}, progress));
    }
    ring = std::move(next);
  }
  return paths;
}

std::vector<Path> pocket(const Outline& area, const ClearSettings& settings, const CutSettings& cut,
                         Progress& progress) {
  const FieldPtr reachable = offset(area.distance, -(cut.radius + cut.allowance));
  if (settings.adaptive) return adaptive(*reachable, area.bounds, area.cell, settings, cut, progress);
  return at_passes(rings(*reachable, area.bounds, area.cell, settings.stepover, 0, cut, progress), cut.depths.passes());
}

std::vector<Vec2> too_narrow(const Outline& area, double radius, Progress& progress) {
  // The tool covers all points within its radius of permitted centres.
  const Loops middles = contours(*area.distance, area.bounds, {area.cell, 0, -radius}, progress);
  const FieldPtr left =
      middles.empty() ? area.distance : intersect(area.distance, complement(offset(outline_field(middles), radius)));
  std::vector<Vec2> places;
  for (const Loop& loop : contours(*left, area.bounds, {area.cell, 0, -0.02 * radius}, progress))
    if (loop.area() > 0.5 * radius * radius) places.push_back(0.5 * (loop.bounds().lower + loop.bounds().upper));
  return places;
}

std::vector<Hole> holes(const Loops& loops, double tolerance) {
  std::vector<Hole> found;
  for (const Loop& loop : loops) {
    const Rectangle box = loop.bounds();
    const Vec2 centre = 0.5 * (box.lower + box.upper);
    double sum = 0;
    for (const Vec2& p : loop.points) sum += (p - centre).norm();
    const double radius = sum / static_cast<double>(loop.points.size());
    const bool round = loop.points.size() >= 8 &&
                       std::all_of(loop.points.begin(), loop.points.end(),
                                   [&](const Vec2& p) { return std::abs((p - centre).norm() - radius) <= tolerance; });
    // The corners of a square also lie on a circle, so the area is compared, too.
    if (round && std::abs(std::abs(loop.area()) - std::numbers::pi * radius * radius) <=
                     2 * std::numbers::pi * radius * 2 * tolerance)
      found.push_back({centre, radius});
  }
  return found;
}

std::vector<Path> drill(const std::vector<Hole>& where, double peck, const Depths& depths) {
  std::vector<Path> paths;
  const std::vector<double> passes = Depths{depths.top, depths.bottom, peck > 0 ? peck : 1e300}.passes();
  for (const Hole& hole : where) {
    Path path;
    const auto add = [&](double z) { path.points.push_back({{hole.centre.x(), hole.centre.y(), z}}); };
    add(depths.top);
    for (std::size_t i = 0; i < passes.size(); ++i) {
      add(passes[i]);
      if (i + 1 < passes.size()) add(depths.top);  // retract to clear chips
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace fieldfab::cam
