// Clearing with constant engagement: each step is steered so that it cuts the same width of
// material.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/plan/distance.h"
#include "fieldfab/cam/plan/material.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"
#include "loop_path.h"
#include "remains.h"

namespace fieldfab::cam {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 towards(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

/// Clears one connected area of permitted tool centres.
class Area {
 public:
  Area(const Loops& walls, double top, double bottom, const ClearSettings& settings, const CutSettings& cut,
       Progress& progress)
      : top_(top),
        bottom_(bottom),
        s_(settings),
        cut_(cut),
        progress_(progress),
        side_(cut.climb ? 1 : -1),
        step_(0.1 * cut.radius),
        walls_(outline_field(walls)),
        region_(walls[0].bounds()),
        cell_(cell_for(region_, cut.radius)),
        left_(region_.grown(cut.radius + 2 * cell_), cell_, cut.radius),
        all_(left_) {
    lay_out(walls);
    all_ = left_;
  }

  std::vector<Path> run() {
    std::vector<Path> paths;
    Path path;
    const double all = std::max(left_.area(), 1e-12);
    if (starts_.empty()) {
      if (left_.area() < 1e-9) return {};
      enter(path);
    } else {
      at_ = starts_.front().at;
    }
    // First with the requested engagement, then with more for the remaining area.
    double uncut = all;
    for (const double most : {1.1 * s_.stepover, 2 * s_.stepover, 4 * cut_.radius}) {
      limit_ = most;
      for (Start& start : starts_) start.tried = false;
      for (Pass pass = next_pass(); !pass.points.empty(); pass = next_pass()) {
        progress_.check();
        uncut -= pass.area;
        progress_.report(1 - uncut / all, "clearing");
        add(pass, path, paths);
      }
    }
    if (!path.points.empty()) paths.push_back(std::move(path));
    sweep_up(paths);
    return paths;
  }

 private:
  /// A possible start of a pass: a point where the tool has been, or can be without cutting.
  struct Start {
    Vec2 at;
    int pass = -1;       // pass that the point belongs to; points of a pass are consecutive
    bool done = false;   // no material is left beside it
    bool tried = false;  // no cut is possible from here with the present limit
  };
  struct Pass {
    std::vector<Vec2> points;
    double area = 0;
    bool reached = false;    // a path without cutting leads to its start
    std::vector<Vec2> over;  // points of that path
  };

  static double cell_for(const Rectangle& region, double radius) {
    // Fine enough for the area of one step; coarser for large pockets, to limit memory.
    const double cell = std::max(radius / 30, std::sqrt(region.size().prod() / 5e7));
    if (cell > radius / 6) throw Error(ErrorKind::too_large, "adaptive", "the area is too large for so small a tool");
    return cell;
  }

  /// Marks as material the area that the tool can cover; if `material` is given, only cells that rise
  /// above the bottom.
  void lay_out(const Loops& walls) {
    Bitmap& cells = left_.cells();
    Bitmap free(cells.width, cells.height, cells.cell, cells.origin, 0);
    mark_inside(walls, free);
    const Lattice<float> reach = distance_transform(free, progress_);
    for (std::size_t i = 0; i < cells.values.size(); ++i)
      if (reach.values[i] < cut_.radius - cell_) cells.values[i] = Remains::full;
    Bitmap solid = free;
    for (std::uint8_t& v : solid.values) v = v == 0 ? 1 : 0;
    clear_ = distance_transform(solid, progress_);
    if (s_.material == nullptr) return;
    bool air = false;
    for (int row = 0; row < cells.height; ++row)
      for (int c = 0; c < cells.width; ++c)
        if (std::uint8_t& here = cells.at(c, row);
            here != 0 && s_.material->highest(cells.place(c, row), 0) <= bottom_ + 1e-3)
          here = 0, air = true;
    if (!air) return;
    // Points beside the material where the tool can be without cutting.
    Bitmap material = cells;
    for (std::uint8_t& v : material.values) v = v != 0 ? 1 : 0;
    const Lattice<float> away = distance_transform(material, progress_);
    const int every = std::max(1, static_cast<int>(0.25 * cut_.radius / cell_));
    for (int row = 0; row < cells.height; row += every)
      for (int c = 0; c < cells.width; c += every)
        if (free.at(c, row) != 0 && away.at(c, row) > cut_.radius + cell_ && away.at(c, row) < 1.5 * cut_.radius)
          starts_.push_back({cells.place(c, row)});
  }

  /// Whether a point is permitted for the tool's centre.
  [[nodiscard]] bool may_be(const Vec2& p) const {
    const Bitmap& cells = left_.cells();
    const Vec2 at = (p - cells.origin) / cell_;
    const int c = static_cast<int>(std::lround(at.x())), r = static_cast<int>(std::lround(at.y()));
    if (c < 0 || r < 0 || c >= cells.width || r >= cells.height) return false;
    if (clear_.at(c, r) > 2 * cell_) return true;
    return walls_->value({p.x(), p.y(), 0}) <= 0;
  }

  /// Enters solid material along a helix at the point with the most clearance.
  void enter(Path& path) {
    const Bitmap& cells = left_.cells();
    std::size_t best = 0;
    for (std::size_t i = 1; i < clear_.values.size(); ++i)
      if (clear_.values[i] > clear_.values[best]) best = i;
    const auto wide = static_cast<std::size_t>(cells.width);
    const Vec2 centre = cells.place(static_cast<double>(best % wide), static_cast<double>(best / wide));
    const double radius = std::min(s_.helix_radius, static_cast<double>(clear_.values[best]) - 2 * cell_);
    const auto add = [&](const Vec2& p, double z, double bulge, Pace pace) {
      path.points.push_back({{p.x(), p.y(), z}, bulge, Vec3::UnitZ(), pace});
    };
    if (!(radius > 0.05 * cut_.radius)) {  // no clearance: straight down
      add(centre, top_, 0, Pace::enter), add(centre, bottom_, 0, Pace::cut);
      left_.cut(centre);
      starts_.push_back({centre});
      at_ = centre;
      return;
    }
    const Vec2 near = centre + Vec2(radius, 0), across = centre - Vec2(radius, 0);
    const double round = std::tan(s_.ramp_angle) * 2 * pi * radius;
    const int halves = 2 * std::max(1, static_cast<int>(std::ceil((top_ - bottom_) / round)));
    for (int k = 0; k < halves; ++k)
      add(k % 2 == 0 ? near : across, top_ + (bottom_ - top_) * k / halves, side_, Pace::enter);
    add(near, bottom_, side_, Pace::enter), add(across, bottom_, side_, Pace::enter), add(near, bottom_, 0, Pace::cut);
    const int around = std::max(16, static_cast<int>(std::ceil(2 * pi * radius / step_)));
    for (int k = 0; k < around; ++k) {
      const Vec2 p = centre + radius * towards(2 * pi * k / around);
      left_.cut(p);
      if (k % 4 == 0) starts_.push_back({p});
    }
    at_ = near;
  }

  /// The point one step ahead, after a turn towards the material. Angles are bearings.
  [[nodiscard]] Vec2 ahead(const Vec2& from, double heading, double turn) const {
    return from + step_ * towards(heading - side_ * turn);
  }
  /// Width that a step cuts, mm.
  [[nodiscard]] double width(const Vec2& from, const Vec2& to) const { return left_.cut_area(from, to) / step_; }

  /// Finds the heading such that the material beside a point lies on the tool's side. Returns false
  /// if there is no such heading.
  bool heading_at(const Vec2& p, double& heading) const {
    constexpr int around = 72;
    const double ring = cut_.radius + 2.5 * cell_;
    bool solid[around];
    int first_free = -1;
    for (int k = 0; k < around; ++k) {
      solid[k] = left_.any(p + ring * towards(2 * pi * k / around));
      if (!solid[k]) first_free = k;
    }
    if (first_free < 0) return heading = 0, true;
    // The longest run of material. It begins behind the tool's side, so that the engagement grows
    // with the turn.
    int longest = 0, end = 0;
    for (int k = 0, run = 0; k <= around; ++k) {
      const int i = (first_free + k) % around;
      if (solid[i] && k < around) {
        ++run;
        continue;
      }
      if (run > longest) longest = run, end = side_ > 0 ? k - 1 : k - run;
      run = 0;
    }
    if (longest == 0) return false;
    heading = 2 * pi * (first_free + end) / around + side_ * pi / 2;
    return true;
  }

  /// The next step, turned so that it cuts the requested width and stays in the permitted area.
  /// Returns false if there is no such step.
  bool steer(const Vec2& at, double heading, double& turn, double& cut) const {
    constexpr double most_in = 0.5, most_out = 0.9;
    double in = most_in, out = -most_out, width_in = -1, width_out = -1;
    const auto cuts = [&](double t) { return width(at, ahead(at, heading, t)); };
    double t = std::clamp(turn, out, in);
    for (int i = 0; i < 12; ++i) {
      cut = cuts(t);
      if (std::abs(cut - s_.stepover) < 0.02 * s_.stepover || in - out < 1e-3) break;
      (cut > s_.stepover ? in : out) = t;
      (cut > s_.stepover ? width_in : width_out) = cut;
      if (width_in < 0 && i > 1) {
        t = in, cut = width_in = cuts(in);
        if (cut < s_.stepover) break;
      } else if (width_out < 0 && i > 1) {
        t = out, cut = width_out = cuts(out);
        if (cut > s_.stepover) break;
      }
      if (width_in >= 0 && width_out >= 0 && i < 6)
        t = out + (in - out) * std::clamp((s_.stepover - width_out) / std::max(width_in - width_out, 1e-12), 0.1, 0.9);
      else
        t = 0.5 * (in + out);
    }
    if (!may_be(ahead(at, heading, t))) {
      double blocked = t;
      do t -= 0.15;
      while (t > -pi && !may_be(ahead(at, heading, t)));
      if (t <= -pi) return false;
      blocked = std::min(blocked, t + 0.15);
      for (int i = 0; i < 8; ++i) {
        const double middle = 0.5 * (blocked + t);
        (may_be(ahead(at, heading, middle)) ? t : blocked) = middle;
      }
      cut = cuts(t);
    }
    turn = t;
    return cut <= limit_;
  }

  /// Cuts from a point until no material is left or the limit is reached.
  Pass pass_from(const Vec2& start, double heading) {
    Pass pass;
    pass.points.push_back(start);
    Vec2 at = start;
    double turn = 0;
    int idle = 0;
    std::size_t engaged = 0;  // number of points up to the last step that cut
    while (idle < 6) {
      double cut = 0;
      if (!steer(at, heading, turn, cut)) break;
      const Vec2 to = ahead(at, heading, turn);
      heading -= side_ * turn;
      if (cut > 0.03 * s_.stepover) {
        idle = 0;
        // The path to the start, determined before the pass removes material.
        if (engaged == 0) pass.reached = way_to(start, pass.over);
        left_.cut(to);
        pass.area += cut * step_;
        engaged = pass.points.size() + 1;
      } else {
        ++idle;
      }
      pass.points.push_back(to);
      at = to;
      if (pass.points.size() % 256 == 0) progress_.check();
    }
    pass.points.resize(engaged);
    return pass;
  }

  /// Pass from the nearest point where a cut is possible; empty if there is none.
  Pass next_pass() {
    std::vector<std::pair<double, std::size_t>> nearest;
    for (std::size_t i = 0; i < starts_.size(); ++i)
      if (!starts_[i].done && !starts_[i].tried) nearest.emplace_back((starts_[i].at - at_).squaredNorm(), i);
    const auto farther = std::greater<>();
    std::make_heap(nearest.begin(), nearest.end(), farther);
    while (!nearest.empty()) {
      std::pop_heap(nearest.begin(), nearest.end(), farther);
      std::size_t i = nearest.back().second;
      nearest.pop_back();
      double heading = 0, earlier = 0;
      if (starts_[i].done || starts_[i].tried) continue;
      if (!heading_at(starts_[i].at, heading)) {
        starts_[i].done = true;
        continue;
      }
      // Back along the front of the earlier pass, so that one pass cuts all of it.
      while (i > 0 && starts_[i].pass >= 0 && starts_[i - 1].pass == starts_[i].pass && !starts_[i - 1].tried &&
             heading_at(starts_[i - 1].at, earlier))
        --i, heading = earlier;
      Pass pass = pass_from(starts_[i].at, heading);
      if (pass.area > 0.05 * s_.stepover * cut_.radius) return pass;
      starts_[i].tried = true;
      if (!pass.points.empty()) return pass;
    }
    return {};
  }

  /// Whether the tool cuts no material on a straight line.
  [[nodiscard]] bool is_clear(const Vec2& from, const Vec2& to) const {
    const double length = (to - from).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / (0.2 * cut_.radius))));
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = from + (to - from) * i / steps;
      if (!may_be(p) || left_.covered_area(p) > 0.02 * s_.stepover * step_) return false;
    }
    return true;
  }
  /// Points of a path without cutting from the end of the last pass: straight, or by way of one of
  /// its points. Returns false if there is none.
  bool way_to(const Vec2& to, std::vector<Vec2>& over) const {
    if (is_clear(at_, to)) return true;
    double shortest = std::numeric_limits<double>::infinity();
    const std::size_t n = last_.size(), every = std::max<std::size_t>(1, n / 12);
    for (std::size_t i = 0; i < n; i += every) {
      const double length = (last_[i] - at_).norm() + (to - last_[i]).norm();
      if (length < shortest && is_clear(at_, last_[i]) && is_clear(last_[i], to)) shortest = length, over = {last_[i]};
    }
    return !over.empty();
  }

  void add(const Pass& pass, Path& path, std::vector<Path>& paths) {
    if (!path.points.empty() && !pass.reached) {
      paths.push_back(std::move(path));
      path = {};
    }
    if (!path.points.empty()) {
      path.points.back().pace = Pace::link;
      for (const Vec2& p : pass.over) path.points.push_back({{p.x(), p.y(), bottom_}, 0, Vec3::UnitZ(), Pace::link});
    }
    const Path fitted = fit_arcs(pass.points, false, bottom_, cut_.tolerance);
    for (const PathPoint& p : fitted.points)
      if (path.points.empty() || (path.points.back().at - p.at).norm() > 1e-9)
        path.points.push_back(p);
      else
        path.points.back() = p;
    path.points.back().bulge = 0;
    const std::size_t apart = 4;
    for (std::size_t i = 0; i < pass.points.size(); ++i)
      if (i % apart == 0 || i + 1 == pass.points.size()) starts_.push_back({pass.points[i], passes_});
    ++passes_;
    at_ = pass.points.back();
    last_ = pass.points;
    std::erase_if(starts_, [](const Start& s) { return s.done; });
  }

  /// Cuts the slivers that remain between fronts that have met, and those caused by the fitted
  /// lines and arcs.
  void sweep_up(std::vector<Path>& paths) {
    left_ = all_;
    for (const Path& path : paths) {
      const std::vector<PathPoint> points = points_along(path, step_);
      for (std::size_t i = 1; i < points.size(); ++i) left_.cut(points[i - 1].at.head<2>(), points[i].at.head<2>());
    }
    Path path;
    const Bitmap& cells = left_.cells();
    for (int row = 0; row < cells.height; ++row)
      for (int c = 0; c < cells.width; ++c) {
        if (cells.at(c, row) == 0) continue;
        Vec2 over = cells.place(c, row);
        for (int i = 0; i < 4 && !may_be(over); ++i) {  // move to the nearest permitted centre
          const Vec3 p(over.x(), over.y(), 0), away = walls_->gradient(p);
          over -= (walls_->value(p) + 0.1 * cell_) * away.head<2>();
        }
        if (!may_be(over)) continue;
        Pass pass;
        pass.points = {over};
        left_.cut(over);
        add(pass, path, paths);
      }
    if (!path.points.empty()) paths.push_back(std::move(path));
  }

  double top_, bottom_;
  const ClearSettings& s_;
  const CutSettings& cut_;
  Progress& progress_;
  double side_;  // side of the material: 1 is right
  double step_;
  FieldPtr walls_;
  Rectangle region_;
  double cell_;
  Remains left_, all_;    // remaining and initial material
  Lattice<float> clear_;  // distance to the walls
  std::vector<Start> starts_;
  double limit_ = 0;  // greatest permitted width of cut
  Vec2 at_ = Vec2::Zero();
  int passes_ = 0;
  std::vector<Vec2> last_;  // the last pass
};

}  // namespace

std::vector<Path> adaptive(const Field& free, const Rectangle& bounds, double cell, const ClearSettings& settings,
                           const CutSettings& cut, Progress& progress) {
  if (!(settings.stepover > 0) || settings.stepover > 2 * cut.radius)
    throw Error(ErrorKind::bad_input, "stepover", "must be above 0 and at most the tool's diameter");
  // Chords and fitted arcs of the passes keep a margin from the walls; the last pass along the
  // walls removes it.
  const double inset = 2 * cut.tolerance + 0.00125 * cut.radius;
  const Loops walls = contours(free, bounds, {cell, 0, -inset}, progress),
              edges = contours(free, bounds, {cell}, progress);
  const std::vector<int> parents = nesting(walls);
  const std::vector<double> passes = cut.depths.passes();
  std::vector<Path> paths, level;
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    const double top = pass == 0 ? cut.depths.top : passes[pass - 1], bottom = passes[pass];
    if (pass > 0 && settings.material == nullptr) {  // repeat: all passes are equal
      for (Path path : level) {
        for (PathPoint& p : path.points) p.at.z() += bottom - passes[0];
        path.level = static_cast<int>(pass);
        paths.push_back(std::move(path));
      }
      continue;
    }
    level.clear();
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (walls[i].area() < 0) continue;
      Loops area{walls[i]};
      for (std::size_t k = 0; k < walls.size(); ++k)
        if (parents[k] == static_cast<int>(i)) area.push_back(walls[k]);
      for (Path& path : Area(area, top, bottom, settings, cut, progress).run()) level.push_back(std::move(path));
    }
    std::vector<Path> along;
    for (const Loop& loop : edges) along.push_back(loop_path(loop, bottom, cut, false));
    if (settings.material != nullptr) along = where_material(along, *settings.material, cut.radius);
    level.insert(level.end(), along.begin(), along.end());
    for (Path& path : level) path.level = static_cast<int>(pass);
    paths.insert(paths.end(), level.begin(), level.end());
  }
  return paths;
}

}  // namespace fieldfab::cam
