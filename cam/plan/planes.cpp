#include "fieldfab/cam/plan/planes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {

Plane plane_along(const Vec3& axis, std::string name) {
  const Vec3 z = axis.normalized(), level = Vec3::UnitZ().cross(z);
  const Vec3 x = level.norm() > 1e-9 ? Vec3(level.normalized()) : Vec3::UnitX();
  Plane plane;
  plane.name = std::move(name);
  plane.axes << x, z.cross(x), z;
  for (int i = 0; i < 9; ++i)  // removes rounding noise of right angles
    if (double& a = plane.axes.data()[i]; std::abs(a - std::round(a)) < 1e-12) a = std::round(a);
  return plane;
}

Plane plane_named(const std::string& name) {
  if (name == "top") return plane_along({0, 0, 1}, name);
  if (name == "bottom") return plane_along({0, 0, -1}, name);
  if (name == "front") return plane_along({0, -1, 0}, name);
  if (name == "back") return plane_along({0, 1, 0}, name);
  if (name == "left") return plane_along({-1, 0, 0}, name);
  if (name == "right") return plane_along({1, 0, 0}, name);
  throw Error(ErrorKind::bad_input, "plane",
              fmt::format("there is no plane '{}'; known are top, bottom, front, back, left, right", name));
}

Plane plane_from_view(double alpha, double beta) {
  // The viewer looks down z after the rotations: this is the direction that they map to z.
  const Vec3 axis =
      Eigen::AngleAxisd(-alpha, Vec3::UnitZ()) * (Eigen::AngleAxisd(-beta, Vec3::UnitX()) * Vec3::UnitZ());
  return plane_along(axis, fmt::format("view {:.4g}, {:.4g}", to_degrees(alpha), to_degrees(beta)));
}

std::vector<Plane> five_planes() {
  std::vector<Plane> planes;
  for (const char* name : {"top", "back", "front", "left", "right"}) planes.push_back(plane_named(name));
  return planes;
}

std::vector<Plane> stepped_planes(int count) {
  if (count < 2) throw Error(ErrorKind::bad_input, "steps", "at least 2 planes a half turn");
  const double step = std::numbers::pi / (count - 1);
  std::vector<Plane> planes{plane_named("top")};
  for (int tilt = 1; tilt * step < std::numbers::pi / 2 + 1e-9; ++tilt)
    for (int turn = 0; turn < 2 * (count - 1); ++turn) {
      const double beta = tilt * step, alpha = turn * step;
      const double up = std::abs(std::cos(beta)) < 1e-12 ? 0 : std::cos(beta);
      planes.push_back(plane_along({std::sin(beta) * std::cos(alpha), std::sin(beta) * std::sin(alpha), up},
                                   fmt::format("{:.4g}, {:.4g}", to_degrees(alpha), to_degrees(beta))));
    }
  return planes;
}

bool Reached::touches(const Vec3& point, const Vec3& normal, double tolerance) const {
  const Vec3 n = plane_.axes.transpose() * normal, q = plane_.into(point);
  if (n.z() < steepest_) return false;
  // The tip of a cutter that touches the point with that normal.
  const FlatCornerCone c = tips_->profile().closed_form();
  if (!c.valid) return false;
  const double level = n.head<2>().norm();
  const Vec2 outward = level > 1e-9 ? Vec2(n.head<2>() / level) : Vec2::Zero();
  const double corner = c.corner, reach = c.flat + corner * level;
  const Vec2 tip_at = q.head<2>() + reach * outward;
  const double tip = q.z() - corner * (1 - n.z()) + tips_->allowance();
  // A slightly lower tip means that a neighbouring point is touched.
  return tips_->tip(tip_at) <= tip + tolerance;
}

std::vector<Path> not_reached(const std::vector<Path>& paths, const Plane& plane, const TipSurface& tips,
                              const Field& part, const std::vector<Reached>& earlier, double tolerance) {
  if (earlier.empty() && !plane.to_the_middle) return paths;
  const double cell = tips.surface().samples().cell;
  std::vector<std::vector<Path>> kept(paths.size());
  parallel_for(paths.size(), [&](std::size_t i) {
    // Closely spaced, so that borders between planes are accurate to one cell.
    std::vector<PathPoint> points;
    const std::vector<PathPoint> given = points_along(paths[i], 0.5 * cell);
    for (std::size_t k = 0; k < given.size(); ++k) {
      if (k > 0) {
        const Vec3 from = given[k - 1].at, way = given[k].at - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / (2 * cell))));
        for (int s = 1; s < steps; ++s) points.push_back({from + way * s / steps});
      }
      points.push_back(given[k]);
    }
    std::vector<bool> wanted(points.size());
    Vec2 guess = points.empty() ? Vec2::Zero() : Vec2(points[0].at.head<2>());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TipSurface::Contact touched = tips.contact(points[k].at.head<2>(), guess);
      guess = touched.place;
      // no contact, because the depth is limited
      if (points[k].at.z() > touched.tip + tolerance) continue;
      const double floor = tips.surface().floor(), height = tips.surface().height(touched.place);
      // this half of the part is empty here
      if (plane.to_the_middle && height <= floor + cell) continue;
      const Vec3 place = plane.out_of(Vec3(touched.place.x(), touched.place.y(), height));
      Vec3 normal;
      if (const auto here = tips.corner_normal(points[k].at.head<2>(), touched)) {
        normal = plane.axes * *here;
      } else {
        const Vec3 slope = part.gradient(place);
        normal = slope.norm() > 0 ? Vec3(slope.normalized()) : Vec3(plane.axes.col(2));
      }
      wanted[k] = std::none_of(earlier.begin(), earlier.end(),
                               [&](const Reached& r) { return r.touches(place, normal, tolerance); });
    }
    // Extended at both ends, so that no gap remains.
    const auto overlap = static_cast<std::ptrdiff_t>(3);
    std::vector<bool> cut(points.size(), false);
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(points.size()); ++k)
      if (wanted[static_cast<std::size_t>(k)])
        for (std::ptrdiff_t o = std::max<std::ptrdiff_t>(0, k - overlap);
             o <= std::min(k + overlap, static_cast<std::ptrdiff_t>(points.size()) - 1); ++o)
          cut[static_cast<std::size_t>(o)] = true;
    Path run;
    const auto finish = [&] {
      if (run.points.size() > 1) {
        std::vector<Vec3> line;
        for (const PathPoint& p : run.points) line.push_back(p.at);
        run.points.clear();
        for (const Vec3& p : simplified(line, 0.1 * tolerance)) run.points.push_back({p});
        kept[i].push_back(run);
      }
      run.points.clear();
    };
    for (std::size_t k = 0; k < points.size(); ++k)
      if (cut[k])
        run.points.push_back(points[k]);
      else
        finish();
    finish();
  });
  std::vector<Path> all;
  for (auto& list : kept) all.insert(all.end(), list.begin(), list.end());
  return all;
}

std::vector<Move> placed(const std::vector<Move>& moves, const Plane& plane, double tolerance) {
  if (plane.is_top() || plane.setup) return moves;
  std::vector<Move> out;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Vec3 axis = moves[i].axis == Vec3::UnitZ() ? Vec3(plane.axes.col(2)) : Vec3(plane.axes * moves[i].axis);
    const auto add = [&](const Vec3& to) { out.push_back({plane.out_of(to), moves[i].feed, 0, axis}); };
    if (moves[i].bulge != 0 && i > 0) {
      Path piece;
      piece.points = {{moves[i - 1].to, moves[i].bulge}, {moves[i].to}};
      const double radius = arc_between(moves[i - 1].to.head<2>(), moves[i].to.head<2>(), moves[i].bulge).radius;
      const auto points = points_along(piece, 2 * std::sqrt(2 * tolerance * std::max(radius, tolerance)));
      for (std::size_t k = 1; k < points.size(); ++k) add(points[k].at);
    } else {
      add(moves[i].to);
    }
  }
  return out;
}

std::vector<Move> transfer(const Move& from, const Move& to, const Box& stock, double clearance, double arm) {
  if (from.axis == to.axis) return {};  // both are already clear of the stock
  std::vector<Move> moves;
  const auto rapid = [&](const Vec3& at, const Vec3& axis) { moves.push_back({at, 0, 0, axis}); };
  if (arm > 0) {
    if (to.axis.z() < -1e-9)
      throw Error(ErrorKind::bad_input, "plane",
                  "overhangs: this machine's head cannot go from plane to plane with the tool pointing upwards "
                  "(Keeter, Algorithm 6.1)");
    const double high = stock.upper.z() + clearance;
    // Up to the height at which the tip is clear after the head has turned straight down.
    const auto lifted = [&](const Move& m) {
      const double tip = std::max(high, m.to.z()) + arm * (1 - m.axis.z());
      return Vec3(m.to.x(), m.to.y(), std::max(tip, m.to.z()));
    };
    const Vec3 up = lifted(from), over = lifted(to);
    if (up != from.to) rapid(up, from.axis);
    const Vec3 upright = up + arm * (from.axis - Vec3::UnitZ());
    if (from.axis != Vec3::UnitZ()) rapid(upright, Vec3::UnitZ());
    // Above the start of the next plane: position of the head's pivot after the turn.
    Vec3 above = over + arm * (to.axis - Vec3::UnitZ());
    const double level = std::max(upright.z(), above.z());
    if (upright.z() < level) rapid({upright.x(), upright.y(), level}, Vec3::UnitZ());
    above.z() = level;
    rapid(above, Vec3::UnitZ());
    if (to.axis != Vec3::UnitZ()) rapid(above - arm * (to.axis - Vec3::UnitZ()), to.axis);
    return moves;
  }
  // The work turns: retract along the tool to a sphere about the stock, move on the sphere, and
  // approach.
  const Vec3 centre = stock.centre();
  const double radius = 0.5 * stock.diagonal() + clearance;
  const auto out_along = [&](const Move& m) {
    const double along = m.axis.dot(m.to - centre);
    return Vec3(m.to + std::max(0.0, radius - along) * m.axis);
  };
  rapid(out_along(from), from.axis);
  rapid(centre + radius * from.axis, from.axis);
  const double angle = std::acos(std::clamp(from.axis.dot(to.axis), -1.0, 1.0));
  Vec3 hinge = from.axis.cross(to.axis);
  // Opposite directions: by way of the vertical, which every table can reach.
  if (hinge.norm() < 1e-9) hinge = from.axis.cross(Vec3::UnitZ());
  if (hinge.norm() < 1e-9) hinge = Vec3::UnitX();
  const int steps = std::max(1, static_cast<int>(std::ceil(angle / to_radians(5))));
  for (int i = 1; i <= steps; ++i) {
    Vec3 axis = i == steps ? to.axis : Vec3(Eigen::AngleAxisd(angle * i / steps, hinge.normalized()) * from.axis);
    rapid(centre + radius * axis, axis);
  }
  rapid(out_along(to), to.axis);
  return moves;
}

}  // namespace fieldfab::cam
