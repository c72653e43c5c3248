#include "fieldfab/cam/plan/material.h"

#include <algorithm>
#include <cmath>

namespace fieldfab::cam {

Material::Material(const Rectangle& block, double top, double cell) {
  const Vec2 size = block.size();
  const int wide = std::max(1, static_cast<int>(std::ceil(size.x() / cell))),
            high = std::max(1, static_cast<int>(std::ceil(size.y() / cell)));
  heights_ = HeightMap(wide, high, cell, block.lower + 0.5 * (size - Vec2(wide - 1, high - 1) * cell),
                       static_cast<float>(top));
}

void Material::cut(const std::vector<Move>& moves, const Profile& profile) {
  const double cell = heights_.cell, radius = profile.radius();
  // Heights of the cutter per cell, taken at the far corner of each cell so that material is not
  // removed in excess.
  const int reach = static_cast<int>(radius / cell);
  std::vector<float> shape;
  for (int v = -reach; v <= reach; ++v)
    for (int u = -reach; u <= reach; ++u) {
      const double away = cell * std::hypot(std::abs(u) + 0.5, std::abs(v) + 0.5);
      shape.push_back(away <= radius ? static_cast<float>(profile.height(away)) : 1e30F);
    }
  const auto stamp = [&](const Vec3& tip) {
    const int column = static_cast<int>(std::lround((tip.x() - heights_.origin.x()) / cell)),
              row = static_cast<int>(std::lround((tip.y() - heights_.origin.y()) / cell));
    std::size_t i = 0;
    for (int v = row - reach; v <= row + reach; ++v)
      for (int u = column - reach; u <= column + reach; ++u, ++i) {
        if (u < 0 || v < 0 || u >= heights_.width || v >= heights_.height) continue;
        float& height = heights_.at(u, v);
        height = std::min(height, static_cast<float>(tip.z()) + shape[i]);
      }
  };
  for (std::size_t k = 1; k < moves.size(); ++k) {
    if (moves[k].rapid()) continue;
    Path piece;
    piece.points = {{moves[k - 1].to, moves[k].bulge}, {moves[k].to}};
    const std::vector<PathPoint> points = points_along(piece, cell);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 from = points[i - 1].at, way = points[i].at - from;
      const int steps = std::max(1, static_cast<int>(std::ceil(way.head<2>().norm() / cell)));
      for (int s = 0; s <= steps; ++s) stamp(from + way * s / steps);
    }
  }
}

double Material::highest(const Vec2& p, double radius) const {
  const Vec2 low = (p - heights_.origin - Vec2::Constant(radius)) / heights_.cell,
             high = (p - heights_.origin + Vec2::Constant(radius)) / heights_.cell;
  const int left = std::max(0, static_cast<int>(std::floor(low.x()))),
            right = std::min(heights_.width - 1, static_cast<int>(std::ceil(high.x())));
  const int bottom = std::max(0, static_cast<int>(std::floor(low.y()))),
            top = std::min(heights_.height - 1, static_cast<int>(std::ceil(high.y())));
  double found = -std::numeric_limits<double>::infinity();
  const double reach = (radius + heights_.cell) * (radius + heights_.cell);
  for (int row = bottom; row <= top; ++row)
    for (int column = left; column <= right; ++column)
      if (heights_.at(column, row) > found && (heights_.place(column, row) - p).squaredNorm() <= reach)
        found = heights_.at(column, row);
  return found;
}

std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius) {
  std::vector<Path> out;
  const double step = std::max(material.heights().cell, radius / 3), least = 1e-3;
  for (const Path& path : paths) {
    std::vector<PathPoint> points;
    for (const PathPoint& p : points_along(path, step)) {
      if (!points.empty()) {
        const Vec3 from = points.back().at, way = p.at - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / step));
        for (int s = 1; s < steps; ++s) points.push_back({from + way * s / steps});
      }
      points.push_back(p);
    }
    std::vector<bool> meets(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      meets[i] = material.highest(points[i].at.head<2>(), radius) > points[i].at.z() + least;
    if (std::none_of(meets.begin(), meets.end(), [](bool b) { return b; })) continue;
    if (std::all_of(meets.begin(), meets.end(), [](bool b) { return b; })) {
      out.push_back(path);
      continue;
    }
    // Runs that meet material, extended by one step at both ends. A closed path starts in the air.
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
  return out;
}

}  // namespace fieldfab::cam
