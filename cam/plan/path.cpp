// Paths: arcs, lengths, and approximation of polylines by lines and arcs.
#include "fieldfab/cam/plan/path.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace fieldfab::cam {

Arc arc_between(const Vec2& from, const Vec2& to, double bulge) {
  const Vec2 chord = to - from, across(-chord.y(), chord.x());
  // The distance of the centre from the chord's midpoint is half the chord divided by the tangent
  // of half the turn.
  const double turn = 4 * std::atan(bulge), lift = (1 - bulge * bulge) / (4 * bulge);
  const Vec2 centre = 0.5 * (from + to) + lift * across;
  return {centre, (from - centre).norm(), turn};
}

namespace {

/// Calls `visit(from, to)` for the two vertices of each piece of the path.
template <class Visit>
void for_pieces(const Path& path, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) visit(path.points[i], path.points[i + 1]);
  if (path.closed && path.points.size() > 1) visit(path.points.back(), path.points.front());
}

}  // namespace

Rectangle Path::bounds() const {
  Rectangle box = Rectangle::nothing();
  for (const PathPoint& p : points) box.add(p.at.head<2>());
  for_pieces(*this, [&](const PathPoint& a, const PathPoint& b) {
    if (a.bulge == 0) return;
    const Vec2 from = a.at.head<2>();
    const Arc arc = arc_between(from, b.at.head<2>(), a.bulge);
    const double start = std::atan2(from.y() - arc.centre.y(), from.x() - arc.centre.x());
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double angle = quarter * std::numbers::pi / 2;
      double passed = arc.turn > 0 ? angle - start : start - angle;
      passed -= std::floor(passed / (2 * std::numbers::pi)) * 2 * std::numbers::pi;
      if (passed < std::abs(arc.turn)) box.add(arc.centre + arc.radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  });
  return box;
}

double length_between(const Vec3& from, const Vec3& to, double bulge) {
  if (bulge == 0) return (to - from).norm();
  const Arc arc = arc_between(from.head<2>(), to.head<2>(), bulge);
  return std::hypot(arc.radius * arc.turn, to.z() - from.z());
}

Vec3 place_between(const Vec3& from, const Vec3& to, double bulge, double share) {
  if (bulge == 0) return from + share * (to - from);
  const Arc arc = arc_between(from.head<2>(), to.head<2>(), bulge);
  const Vec2 out = from.head<2>() - arc.centre;
  const double c = std::cos(share * arc.turn), s = std::sin(share * arc.turn);
  return {arc.centre.x() + c * out.x() - s * out.y(), arc.centre.y() + s * out.x() + c * out.y(),
          from.z() + share * (to.z() - from.z())};
}

double Path::length() const {
  double sum = 0;
  for_pieces(*this, [&](const PathPoint& a, const PathPoint& b) { sum += length_between(a.at, b.at, a.bulge); });
  return sum;
}

void reverse(Path& path) {
  const std::size_t n = path.points.size();
  std::vector<PathPoint> turned;
  for (std::size_t i = n; i-- > 0;) {
    turned.push_back(path.points[i]);
    turned.back().bulge = i > 0 ? -path.points[i - 1].bulge : path.closed ? -path.points[n - 1].bulge : 0;
  }
  path.points = std::move(turned);
}

std::vector<PathPoint> points_along(const Path& path, double step) {
  std::vector<PathPoint> points;
  for_pieces(path, [&](const PathPoint& a, const PathPoint& b) {
    points.push_back(a);
    if (a.bulge == 0) return;
    const Arc arc = arc_between(a.at.head<2>(), b.at.head<2>(), a.bulge);
    const int count = std::max(1, static_cast<int>(std::ceil(arc.radius * std::abs(arc.turn) / step)));
    for (int i = 1; i < count; ++i) {
      const double share = static_cast<double>(i) / count;
      PathPoint p = a;
      p.at = place_between(a.at, b.at, a.bulge, share);
      p.axis = ((1 - share) * a.axis + share * b.axis).normalized();
      points.push_back(p);
    }
  });
  for (PathPoint& p : points) p.bulge = 0;
  if (!path.points.empty()) points.push_back(path.closed ? path.points.front() : path.points.back());
  points.back().bulge = 0;
  return points;
}

namespace {

/// Replacement of a run of vertices: a line or an arc.
struct Fit {
  double bulge = 0;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.squaredNorm();
  return (p - a - (length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0) * along).norm();
}

std::optional<Fit> fit_line(std::span<const Vec2> run, double tolerance) {
  for (std::size_t i = 1; i + 1 < run.size(); ++i)
    if (distance_to_segment(run[i], run.front(), run.back()) > tolerance) return std::nullopt;
  return Fit{};
}

/// Arc from the first vertex to the last by least squares through the others; std::nullopt if a
/// deviation exceeds the tolerance.
std::optional<Fit> fit_arc(std::span<const Vec2> run, double tolerance) {
  const Vec2 &a = run.front(), &b = run.back();
  const Vec2 chord = b - a;
  const double length = chord.norm();
  if (run.size() < 4 || length < 1e-9) return std::nullopt;
  // In coordinates (u, v) along and across the chord, a vertex on the circle with centre height h
  // satisfies 2 h v = u^2 + v^2 - (length/2)^2.
  const Vec2 along = chord / length, across(-along.y(), along.x()), middle = 0.5 * (a + b);
  double top = 0, bottom = 0;
  for (std::size_t i = 1; i + 1 < run.size(); ++i) {
    const Vec2 d = run[i] - middle;
    const double u = d.dot(along), v = d.dot(across);
    top += v * (u * u + v * v - length * length / 4), bottom += 2 * v * v;
  }
  if (bottom < 1e-18) return std::nullopt;
  const double lift = top / bottom, radius = std::hypot(lift, length / 2);
  constexpr double flattest = 1e4;
  if (!(radius < flattest)) return std::nullopt;
  const Vec2 centre = middle + lift * across;
  double turned = 0;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    const Vec2 p = run[i] - centre, q = run[i + 1] - centre;
    if (std::abs(p.norm() - radius) > tolerance || std::abs((0.5 * (p + q)).norm() - radius) > tolerance)
      return std::nullopt;
    const double angle = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    if (i > 0 && angle * turned <= 0) return std::nullopt;  // the turn reverses
    turned += angle;
  }
  if (std::abs(turned) > std::numbers::pi * 1.001 || std::abs(turned) * radius < 1e-6) return std::nullopt;
  return Fit{std::tan(std::clamp(turned, -std::numbers::pi, std::numbers::pi) / 4)};
}

/// Last index of the longest run from `first` that `fit` accepts, by doubling and bisection.
std::size_t longest(std::span<const Vec2> points, std::size_t first, double tolerance,
                    const std::function<std::optional<Fit>(std::span<const Vec2>, double)>& fit, std::size_t shortest,
                    Fit& found) {
  const auto accepts = [&](std::size_t last) {
    const auto result = fit(points.subspan(first, last - first + 1), tolerance);
    if (result) found = *result;
    return result.has_value();
  };
  std::size_t good = first, bad = points.size();
  for (std::size_t step = shortest; first + step < points.size(); step *= 2) {
    if (!accepts(first + step)) {
      bad = first + step;
      break;
    }
    good = first + step;
  }
  while (good > first && good + 1 < bad) {
    const std::size_t middle = (good + bad) / 2;
    (accepts(middle) ? good : bad) = middle;
  }
  if (good > first) accepts(good);  // stores its fit in `found`
  return good;
}

/// Vertex with the sharpest turn of a closed polyline, so that its corners become ends of lines and
/// arcs.
std::size_t sharpest(std::span<const Vec2> points) {
  std::size_t best = 0;
  double least = 2;
  for (std::size_t i = 0, n = points.size(); i < n; ++i) {
    const Vec2 before = (points[i] - points[(i + n - 1) % n]).normalized(),
               after = (points[(i + 1) % n] - points[i]).normalized();
    if (const double cosine = before.dot(after); cosine < least - 1e-3) least = cosine, best = i;
  }
  return best;
}

}  // namespace

Path fit_arcs(std::span<const Vec2> points, bool closed, double z, double tolerance) {
  Path path;
  path.closed = closed;
  if (points.empty()) return path;
  std::vector<Vec2> run(points.begin(), points.end());
  if (closed) {
    std::rotate(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(sharpest(points)), run.end());
    run.push_back(run.front());
  }
  for (std::size_t i = 0; i + 1 < run.size();) {
    Fit line, arc;
    const std::size_t line_end = longest(run, i, tolerance, fit_line, 1, line),
                      arc_end = longest(run, i, tolerance, fit_arc, 3, arc);
    const bool bent = arc_end > line_end + 1;
    path.points.push_back({{run[i].x(), run[i].y(), z}, bent ? arc.bulge : 0.0});
    i = bent ? arc_end : line_end;
  }
  if (!closed) path.points.push_back({{run.back().x(), run.back().y(), z}});
  return path;
}

std::vector<Vec3> simplified(std::span<const Vec3> points, double tolerance) {
  std::vector<Vec3> kept;
  if (points.empty()) return kept;
  kept.push_back(points[0]);
  const auto straight = [&](std::size_t first, std::size_t last) {
    const Vec3 along = points[last] - points[first];
    const double length = along.squaredNorm();
    for (std::size_t i = first + 1; i < last; ++i) {
      const Vec3 d = points[i] - points[first];
      if ((d - (length > 0 ? std::clamp(d.dot(along) / length, 0.0, 1.0) : 0.0) * along).squaredNorm() >
          tolerance * tolerance)
        return false;
    }
    return true;
  };
  for (std::size_t first = 0; first + 1 < points.size();) {
    std::size_t good = first + 1, bad = points.size();
    for (std::size_t step = 2; first + step < points.size(); step *= 2) {
      if (!straight(first, first + step)) {
        bad = first + step;
        break;
      }
      good = first + step;
    }
    while (good + 1 < bad) {
      const std::size_t middle = (good + bad) / 2;
      (straight(first, middle) ? good : bad) = middle;
    }
    kept.push_back(points[good]);
    first = good;
  }
  return kept;
}

}  // namespace fieldfab::cam
