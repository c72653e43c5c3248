#include "fieldfab/cam/plan/material.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {

Material::Material(const Rectangle& block, double top, double cell) {
  const Vec2 size = block.size();
  const int wide = std::max(1, static_cast<int>(std::ceil(size.x() / cell))),
            high = std::max(1, static_cast<int>(std::ceil(size.y() / cell)));
  heights_ = HeightMap(wide, high, cell, block.lower + 0.5 * (size - Vec2(wide - 1, high - 1) * cell),
                       static_cast<float>(top));
  certain_ = heights_;
}

namespace {

/// Raises the cells of a map whose squares come within `reach` of a point.
void raise(HeightMap& map, const Vec3& at, double reach) {
  const auto height = static_cast<float>(at.z());
  const Vec2 p = (at.head<2>() - map.origin) / map.cell;
  const double r = reach / map.cell;
  const auto first = [&](double x) { return std::max(0, static_cast<int>(std::ceil(x - r - 0.5))); };
  const auto last = [&](double x, int count) { return std::min(count - 1, static_cast<int>(std::floor(x + r + 0.5))); };
  for (int row = first(p.y()); row <= last(p.y(), map.height); ++row)
    for (int column = first(p.x()); column <= last(p.x(), map.width); ++column) {
      const double x = std::max(0.0, std::abs(column - p.x()) - 0.5), y = std::max(0.0, std::abs(row - p.y()) - 0.5);
      if (x * x + y * y > r * r + 1e-9) continue;
      float& here = map.at(column, row);
      here = std::max(here, height);
    }
}

}  // namespace

Material::Material(const Stock& stock, const Plane& plane, const std::function<double(std::uint32_t)>& slack,
                   bool whole, Progress& progress)
    : whole_(whole) {
  const Box box = plane.into(stock.lattice().box());
  const Vec3& spacing = stock.lattice().spacing();
  const Vec3 view = plane.axes.col(2);
  int axis = 0;
  const bool along = view.cwiseAbs().maxCoeff(&axis) > 1 - 1e-9;
  const double cell = spacing.maxCoeff();
  // Cells lie about lines of the lattice, if the plane looks along them.
  const int wide = static_cast<int>(std::ceil(box.size().x() / cell - 1e-6)) + 1,
            high = static_cast<int>(std::ceil(box.size().y() / cell - 1e-6)) + 1;
  heights_ = certain_ = HeightMap(wide, high, cell, box.lower.head<2>(), -std::numeric_limits<float>::infinity());
  const std::vector<std::vector<StockCrossing>> crossings = stock.crossings(progress);
  const auto for_crossings = [&](const auto& visit) {
    for (const auto& of_brick : crossings)
      for (const StockCrossing& c : of_brick)
        // A line stands for the material about it. Ends of material on lines are exact.
        if (!along || (c.axis == axis && c.upwards == (view[axis] > 0))) visit(c);
  };
  const double half = 0.499 * std::max(spacing[(axis + 1) % 3], spacing[(axis + 2) % 3]);
  // Each point of the material has a solid point of the lattice within two halves of its diagonal: a cut removes
  // points only where it is sure, across its axis, and the next points below its floor stay.
  const double near = spacing.norm();
  parallel_for(2, [&](std::size_t map) {
    if (map == 0)
      for_crossings([&](const StockCrossing& c) {
        if (along)
          raise(heights_, plane.into(c.place), half);
        else
          raise(heights_, plane.into(c.solid) + Vec3(0, 0, near), near);
      });
    else
      for_crossings([&](const StockCrossing& c) {
        raise(certain_, plane.into(c.place) - Vec3(0, 0, slack(c.cut)), along ? half : 0);
      });
  });
}

namespace {

/// Whether a condition on (cell's height, squared distance of its centre) holds for a cell with its centre within
/// `reach` of a point.
template <class Condition>
bool any_near(const HeightMap& map, const Vec2& p, double reach, const Condition& holds) {
  const Vec2 low = (p - map.origin - Vec2::Constant(reach)) / map.cell,
             high = (p - map.origin + Vec2::Constant(reach)) / map.cell;
  const int left = std::max(0, static_cast<int>(std::ceil(low.x()))),
            right = std::min(map.width - 1, static_cast<int>(std::floor(high.x())));
  const int bottom = std::max(0, static_cast<int>(std::ceil(low.y()))),
            top = std::min(map.height - 1, static_cast<int>(std::floor(high.y())));
  for (int row = bottom; row <= top; ++row)
    for (int column = left; column <= right; ++column) {
      const double squared = (map.place(column, row) - p).squaredNorm();
      if (squared <= reach * reach && holds(map.at(column, row), squared)) return true;
    }
  return false;
}

}  // namespace

bool Material::may_meet(const Vec3& tip, const Profile& cutter, double least) const {
  const double half = 0.7072 * heights_.cell;
  return any_near(heights_, tip.head<2>(), cutter.radius() + half, [&](double height, double squared) {
    const double above = height - tip.z() - least;
    return above > 0 && above > cutter.height(std::clamp(std::sqrt(squared) - half, 0.0, cutter.radius()));
  });
}

double Material::greatest(const HeightMap& map, const Vec2& p, double reach) {
  double found = -std::numeric_limits<double>::infinity();
  any_near(map, p, reach, [&](double height, double) {
    found = std::max(found, height);
    return false;
  });
  return found;
}

namespace {

// A path that only just misses material for a short way is not divided: in radii of the tool.
constexpr double wider = 1.25, longest_gap = 12;

/// Fills gaps between true values of at most `most` values along which `near(i)` holds.
template <class Near>
void keep_along_material(std::vector<bool>& meets, const Near& near, std::size_t most) {
  std::size_t last = meets.size();  // the last true value
  for (std::size_t i = 0; i < meets.size(); ++i) {
    if (!meets[i]) continue;
    if (last < i && i - last - 1 <= most) {
      std::size_t k = last + 1;
      while (k < i && near(k)) ++k;
      if (k == i)
        for (k = last + 1; k < i; ++k) meets[k] = true;
    }
    last = i;
  }
}

/// Points of a path at most `step` mm apart.
std::vector<PathPoint> close_points(const Path& path, double step) {
  std::vector<PathPoint> points;
  for (const PathPoint& p : points_along(path, step)) {
    if (!points.empty()) {
      const Vec3 from = points.back().at, way = p.at - from;
      const int steps = static_cast<int>(std::ceil(way.norm() / step));
      for (int s = 1; s < steps; ++s) points.push_back({from + way * s / steps});
    }
    points.push_back(p);
  }
  return points;
}

/// Adds the runs of a path's points that meet material, extended by one point at both ends, to `out`. A path that meets
/// material everywhere stays as it is; a closed path starts in the air.
void add_runs(const Path& path, const std::vector<PathPoint>& points, const std::vector<bool>& meets,
              std::vector<Path>& out) {
  if (std::none_of(meets.begin(), meets.end(), [](bool b) { return b; })) return;
  if (std::all_of(meets.begin(), meets.end(), [](bool b) { return b; })) return out.push_back(path);
  const std::size_t n = points.size() - (path.closed ? 1 : 0);
  std::size_t first = 0;
  if (path.closed) first = static_cast<std::size_t>(std::find(meets.begin(), meets.end(), false) - meets.begin());
  Path run;
  run.level = path.level;
  const auto finish = [&] {
    if (run.points.size() > 1) {
      std::vector<Vec3> line;
      for (const PathPoint& p : run.points) line.push_back(p.at);
      run.points.clear();
      for (const Vec3& p : simplified(line, 1e-3)) run.points.push_back({p});
      out.push_back(run);
    }
    run.points.clear();
  };
  for (std::size_t k = 0; k < n + (path.closed ? 1 : 0); ++k) {
    const std::size_t i = (first + k) % n, before = (i + n - 1) % n, after = (i + 1) % n;
    const bool wanted =
        meets[i] || ((path.closed || i > 0) && meets[before]) || ((path.closed || i + 1 < n) && meets[after]);
    if (wanted)
      run.points.push_back(points[i]);
    else
      finish();
  }
  finish();
}

}  // namespace

std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius) {
  std::vector<Path> out;
  const double step = std::max(material.cell(), radius / 3), least = 1e-3;
  for (const Path& path : paths) {
    const std::vector<PathPoint> points = close_points(path, step);
    const auto meets_within = [&](const PathPoint& p, double reach) {
      return material.certain(p.at.head<2>(), reach) > p.at.z() + least;
    };
    std::vector<bool> meets(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) meets[i] = meets_within(points[i], radius);
    keep_along_material(
        meets, [&](std::size_t i) { return meets_within(points[i], wider * radius); },
        static_cast<std::size_t>(longest_gap * radius / step));
    add_runs(path, points, meets, out);
  }
  return out;
}

std::vector<Path> without_air(const std::vector<Path>& paths, const Material& material, const Profile& cutter,
                              double tolerance) {
  if (!material.whole()) return paths;
  // Between points the cutter is nowhere deeper than at them by more than the tolerance.
  const double radius = cutter.radius(), step = std::min(radius / 6, std::sqrt(8 * radius * tolerance));
  std::vector<std::vector<Path>> kept(paths.size());
  parallel_for(paths.size(), [&](std::size_t k) {
    const std::vector<PathPoint> points = close_points(paths[k], step);
    std::vector<bool> meets(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) meets[i] = material.may_meet(points[i].at, cutter, tolerance);
    // A short way through the air takes less time than rising over it.
    keep_along_material(
        meets, [](std::size_t) { return true; }, static_cast<std::size_t>(longest_gap * radius / step));
    add_runs(paths[k], points, meets, kept[k]);
  });
  std::vector<Path> out;
  for (std::vector<Path>& runs : kept) std::move(runs.begin(), runs.end(), std::back_inserter(out));
  return out;
}

}  // namespace fieldfab::cam
