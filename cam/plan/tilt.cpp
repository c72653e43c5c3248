#include "fieldfab/cam/plan/tilt.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "fieldfab/core/linear_maps.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Spherical interpolation between two directions.
Vec3 between(const Vec3& from, const Vec3& to, double share) {
  return Eigen::Quaterniond::Identity().slerp(share, turn_between(from, to)) * from;
}

/// The axis, limited to the angle `most` from z.
Vec3 within_cone(const Vec3& axis, double most) {
  const double angle = angle_between(Vec3::UnitZ(), axis);
  return angle <= most ? axis : between(Vec3::UnitZ(), axis, most / angle);
}

/// Tilts the tool along one path.
class Leaning {
 public:
  Leaning(const TipSurface& tips, const Tool& tool, const Plane& plane, const FreeSpace& space,
          const TiltSettings& settings)
      : tips_(tips), plane_(plane), space_(space), s_(settings) {
    ball_ = tool.shape == ToolShape::ball ? tool.radius() : tool.corner_radius;
    for (const Frustum& piece : pieces_of(tool, settings.clearance, space.bounds().diagonal())) {
      (piece.cuts ? cutter_ : body_).push_back(piece);
      if (piece.cuts)  // the cutter touches the part
        for (double* const radius : {&cutter_.back().radius_from, &cutter_.back().radius_to})
          *radius = std::max(0.0, *radius - settings.tolerance);
      reach_ = std::max(reach_, std::min(piece.to, tool.length + tool.holder_length));
    }
    // The tool's far end moves by at most the clearance between two poses.
    turn_ = std::clamp(settings.clearance / std::max(reach_, 1.0), 0.002, 0.05);
    step_ = std::max(0.5 * settings.clearance, 0.1);
  }

  std::vector<Path> lean(const Path& path, TiltReport& report) const {
    std::vector<Station> stations = along(path);
    if (stations.size() < 2) return {};
    wish(stations);
    for (Station& station : stations) station.axis = nearest_clear(station.middle, station.wish);
    smooth(stations);
    std::vector<Path> runs(1);
    const auto add = [&](const Station& s, const Vec3& axis) {
      runs.back().points.push_back({s.middle - ball_ * axis, 0, axis});
    };
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Station& here = stations[i];
      const double length = i == 0 ? 0 : (here.middle - stations[i - 1].middle).norm();
      bool joined = false;
      if (here.axis && i > 0 && stations[i - 1].axis && !runs.back().points.empty())
        joined = turn_between(stations[i - 1], here, 0, runs.back());
      if (!here.axis || !joined) {
        if (!runs.back().points.empty()) runs.emplace_back();
        report.left_out += length;
        if (!here.axis) continue;
        add(here, *here.axis);
        continue;
      }
      (angle_between(*here.axis, here.wish) < 0.02 ? report.leaning : report.otherwise) += length;
    }
    std::erase_if(runs, [](const Path& run) { return run.points.size() < 2; });
    for (Path& run : runs) run.level = path.level;
    return runs;
  }

 private:
  /// Position of the ball's centre, in the plane's coordinates.
  struct Station {
    Vec3 middle, normal, wish = Vec3::UnitZ();
    std::optional<Vec3> axis;
  };

  [[nodiscard]] std::vector<Station> along(const Path& path) const {
    std::vector<Station> stations;
    const std::vector<PathPoint> points = points_along(path, std::min(step_, 0.1));
    Vec2 guess = points.front().at.head<2>();
    const auto add = [&](const Vec3& tip) {
      Station s;
      s.middle = tip + ball_ * Vec3::UnitZ();
      const TipSurface::Contact touched = tips_.contact(tip.head<2>(), guess);
      guess = touched.place;
      const Vec3 from(touched.place.x(), touched.place.y(), tips_.surface().height(touched.place));
      const Vec3 away = s.middle - from;
      s.normal = away.norm() > 1e-9 && touched.tip > tip.z() - ball_ ? Vec3(away.normalized()) : Vec3(Vec3::UnitZ());
      stations.push_back(s);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& to = points[i].at;
      if (i == 0) {
        add(to);
        continue;
      }
      const Vec3 from = points[i - 1].at;
      const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_)));
      for (int k = 1; k <= steps; ++k) add(from + (to - from) * k / steps);
    }
    return stations;
  }

  /// Preferred axes: the surface normal, averaged over the ball's radius and inclined forward by
  /// the lead angle.
  void wish(std::vector<Station>& stations) const {
    const std::size_t n = stations.size();
    std::size_t first = 0, last = 0;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      while (last < n && (stations[last].middle - stations[i].middle).norm() <= ball_) sum += stations[last++].normal;
      while (first < i && (stations[first].middle - stations[i].middle).norm() > ball_) sum -= stations[first++].normal;
      Vec3 normal = sum.norm() > 1e-6 ? Vec3(sum.normalized()) : stations[i].normal;
      const Vec3 travel = stations[std::min(i + 1, n - 1)].middle - stations[i > 0 ? i - 1 : 0].middle;
      const Vec3 ahead = travel - normal.dot(travel) * normal;
      if (ahead.norm() > 1e-9) normal = std::cos(s_.lead) * normal + std::sin(s_.lead) * ahead.normalized();
      stations[i].wish = within_cone(normal, s_.most);
    }
  }

  [[nodiscard]] bool clear(const Vec3& middle, const Vec3& axis) const {
    const Vec3 at = plane_.out_of(Vec3(middle - ball_ * axis)), along = plane_.axes * axis;
    for (const Frustum& piece : body_)
      if (!space_.clear(at, along, piece, 0.25 * s_.clearance)) return false;
    // A vertical tool is clear by the construction of the paths.
    if (axis != Vec3::UnitZ())
      for (const Frustum& piece : cutter_)
        if (!space_.clear(at, along, piece, 0.5 * s_.tolerance)) return false;
    return true;
  }

  [[nodiscard]] std::optional<Vec3> nearest_clear(const Vec3& middle, const Vec3& wish) const {
    for (const double share : {0.0, 0.15, 0.3, 0.45, 0.6, 0.8}) {
      const Vec3 axis = between(wish, Vec3::UnitZ(), share);
      if (clear(middle, axis)) return axis;
    }
    std::vector<Vec3> others{Vec3::UnitZ()};
    for (const double tilt : {0.25, 0.5, 0.75, 1.0})
      for (int k = 0; k < 12; ++k) {
        const double t = tilt * s_.most, turn = std::numbers::pi * k / 6;
        others.emplace_back(std::sin(t) * std::cos(turn), std::sin(t) * std::sin(turn), std::cos(t));
      }
    std::sort(others.begin(), others.end(), [&](const Vec3& a, const Vec3& b) { return a.dot(wish) > b.dot(wish); });
    for (const Vec3& axis : others)
      if (clear(middle, axis)) return axis;
    return std::nullopt;
  }

  /// Replaces each axis by a weighted mean with its neighbours, if that is clear.
  void smooth(std::vector<Station>& stations) const {
    for (int round = 0; round < 4; ++round)
      for (std::size_t i = 1; i + 1 < stations.size(); ++i) {
        Station& s = stations[i];
        if (!s.axis || !stations[i - 1].axis || !stations[i + 1].axis) continue;
        const Vec3 even = (*stations[i - 1].axis + 2 * *s.axis + *stations[i + 1].axis).normalized();
        if (angle_between(even, *s.axis) > 0.01 && clear(s.middle, even)) s.axis = even;
      }
  }

  /// Connects two poses by sufficiently small turns. Returns false for an obstacle.
  bool turn_between(const Station& from, const Station& to, int depth, Path& path) const {
    const double angle = angle_between(*from.axis, *to.axis);
    if (angle > turn_) {
      if (depth > 10) return false;
      Station half = to;
      half.middle = 0.5 * (from.middle + to.middle);
      half.axis = between(*from.axis, *to.axis, 0.5);
      return clear(half.middle, *half.axis) && turn_between(from, half, depth + 1, path) &&
             turn_between(half, to, depth + 1, path);
    }
    path.points.push_back({to.middle - ball_ * *to.axis, 0, *to.axis});
    return true;
  }

  const TipSurface& tips_;
  const Plane& plane_;
  const FreeSpace& space_;
  const TiltSettings& s_;
  double ball_ = 0, reach_ = 0, turn_ = 0, step_ = 0;
  std::vector<Frustum> cutter_, body_;
};

/// Removes poses that linear interpolation reproduces within the tolerance.
void simplify(Path& path, double tolerance) {
  std::vector<PathPoint> kept{path.points.front()};
  std::size_t from = 0;
  for (std::size_t to = 2; to <= path.points.size(); ++to) {
    bool even = to < path.points.size();
    for (std::size_t k = from + 1; even && k < to; ++k) {
      const PathPoint &a = path.points[from], &b = path.points[to], &p = path.points[k];
      const double whole = (b.at - a.at).norm(),
                   share = whole > 0 ? std::clamp((p.at - a.at).dot(b.at - a.at) / (whole * whole), 0.0, 1.0) : 0;
      even = (a.at + share * (b.at - a.at) - p.at).norm() < 0.25 * tolerance &&
             angle_between((a.axis + share * (b.axis - a.axis)).normalized(), p.axis) < 0.001 && to - from < 64;
    }
    if (!even) kept.push_back(path.points[to - 1]), from = to - 1;
  }
  path.points = std::move(kept);
}

}  // namespace

std::vector<Frustum> pieces_of(const Tool& tool, double clearance, double beyond) {
  const double ball = tool.shape == ToolShape::ball ? tool.radius() : tool.corner_radius, radius = tool.radius();
  const double flute = tool.flute > 0 ? tool.flute : tool.length > 0 ? tool.length : 3 * tool.diameter;
  std::vector<Frustum> pieces;
  const double taper = tool.shape == ToolShape::tapered ? std::tan(tool.angle / 2) : 0;
  double at = ball;
  if (taper > 0) {
    const double widest = std::min(flute, ball + (radius - ball) / taper);
    pieces.push_back({at, widest, ball, radius, true});
    at = widest;
  }
  if (flute > at) pieces.push_back({at, flute, radius, radius, true}), at = flute;
  const double shank = (tool.shank > 0 ? tool.shank / 2 : radius) + clearance;
  const double holder = tool.length > 0 ? tool.length : at;
  const bool held = tool.holder_diameter > 0;
  pieces.push_back({at, held ? std::max(at, holder) : at + beyond, shank, shank, false});
  if (held)
    pieces.push_back({holder - clearance, holder + beyond, tool.holder_diameter / 2 + clearance,
                      tool.holder_diameter / 2 + clearance, false});
  return pieces;
}

std::vector<Path> tilted(const std::vector<Path>& paths, const TipSurface& tips, const Tool& tool, const Plane& plane,
                         const FreeSpace& space, const TiltSettings& settings, TiltReport& report, Progress& progress) {
  const Leaning leaning(tips, tool, plane, space, settings);
  std::vector<std::vector<Path>> leant(paths.size());
  std::mutex adding;
  std::size_t done = 0;
  parallel_for(paths.size(), [&](std::size_t i) {
    progress.check();
    TiltReport own;
    leant[i] = leaning.lean(paths[i], own);
    for (Path& path : leant[i]) simplify(path, settings.tolerance);
    const std::lock_guard lock(adding);
    report.leaning += own.leaning, report.otherwise += own.otherwise, report.left_out += own.left_out;
    progress.report(static_cast<double>(++done) / static_cast<double>(paths.size()), "tilting");
  });
  std::vector<Path> all;
  for (auto& list : leant)
    for (Path& path : list) all.push_back(std::move(path));
  return all;
}

}  // namespace fieldfab::cam
