// Conversion of paths to moves (rapids, entries, cuts), and machining time.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/names.h"
#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {
namespace {

constexpr std::array<std::string_view, 3> coolant_names{"none", "mist", "flood"};

}  // namespace

std::string_view name_of(Coolant coolant) { return coolant_names[static_cast<std::size_t>(coolant)]; }

Coolant coolant_named(std::string_view name, const std::string& place) {
  return named<Coolant>(name, coolant_names, "coolant", place);
}

bool Section::tilted() const {
  return std::any_of(moves.begin(), moves.end(), [](const Move& m) { return m.axis != Vec3::UnitZ(); });
}

namespace {

class Linker {
 public:
  explicit Linker(const LinkSettings& settings) : s_(settings) {}

  void add(const Path& path) {
    if (path.points.empty()) return;
    const PathPoint& first = path.points.front();
    axis_ = first.axis;
    const bool same_way = !moves_.empty() && moves_.back().axis == Vec3::UnitZ() && axis_ == Vec3::UnitZ();
    if (!same_way || !(s_.may_stay_down && s_.may_stay_down(moves_.back().to, first.at))) {
      retract();
      rapid(up_from(first.at));
      enter(path);
    } else {
      cut(first.at, s_.feed);
    }
    follow(path);
  }

  std::vector<Move> take() {
    retract();
    return std::move(moves_);
  }

 private:
  void rapid(const Vec3& to) { moves_.push_back({to, 0, 0, axis_}); }
  void cut(const Vec3& to, double feed, double bulge = 0) {
    if (bulge == 0 && moves_.back().axis == axis_ && (moves_.back().to - to).norm() < 1e-9) return;
    moves_.push_back({to, feed, bulge, axis_});
  }
  /// The point along the tool's axis at the clearance height.
  [[nodiscard]] Vec3 up_from(const Vec3& p, double z) const {
    return axis_ == Vec3::UnitZ() ? Vec3(p.x(), p.y(), z) : Vec3(p + axis_ * (z - p.z()) / axis_.z());
  }
  [[nodiscard]] Vec3 up_from(const Vec3& p) const { return up_from(p, s_.clearance); }
  void retract() {
    if (moves_.empty() || moves_.back().to.z() >= s_.clearance) return;
    const Vec3 next = std::exchange(axis_, moves_.back().axis);
    rapid(up_from(moves_.back().to));
    axis_ = next;
  }

  void enter(const Path& path) {
    const Vec3 start = path.points.front().at;
    const double material = s_.material ? std::min(s_.material(path), s_.clearance) : s_.clearance;
    const double from = std::clamp(material + s_.above, start.z(), s_.clearance);
    if (from < s_.clearance) rapid(up_from(start, from));
    if (from > start.z() && s_.entry == Entry::helix && wind_down(start, from)) return;
    if (from > start.z() && s_.entry != Entry::plunge && path.closed && path.length() > 1e-3)
      return descend(path, from);
    cut(start, s_.plunge);
  }

  /// Enters along a helix beside `start`, if its circle and the line from there to the start are
  /// clear. Returns false otherwise.
  bool wind_down(const Vec3& start, double from) {
    const double radius = s_.helix_radius;
    if (!(radius > 0) || !s_.may_stay_down) return false;
    constexpr int sides = 8, chords = 16;
    // distance of the circle's centre in radii: in a corner only greater distances are clear
    for (const double distance : {1.0, 1.5, 2.2})
      for (int side = 0; side < sides; ++side) {
        const double towards = 2 * std::numbers::pi * side / sides;
        const Vec3 out(std::cos(towards), std::sin(towards), 0), centre = start + distance * radius * out,
                                                                 near = centre - radius * out;
        const auto on_circle = [&](int k) {
          const double angle = towards + std::numbers::pi + 2 * std::numbers::pi * k / chords;
          return Vec3(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0));
        };
        bool room = s_.may_stay_down(near, start);
        for (int k = 0; k < chords && room; ++k) room = s_.may_stay_down(on_circle(k), on_circle(k + 1));
        if (!room) continue;
        wind_down(near, 2 * centre - near, from, radius);
        cut(start, s_.feed);
        return true;
      }
    return false;
  }
  /// Half circles between two opposite points, descending within the permitted slope, ending at the
  /// first point.
  void wind_down(const Vec3& near, const Vec3& across, double from, double radius) {
    const double round = std::tan(s_.ramp_angle) * 2 * std::numbers::pi * radius;
    const int halves = 2 * std::max(1, static_cast<int>(std::ceil((from - near.z()) / round)));
    cut({near.x(), near.y(), from}, s_.plunge);
    for (int k = 1; k <= halves; ++k) {
      const Vec3& at = k % 2 == 0 ? near : across;
      cut({at.x(), at.y(), from + (near.z() - from) * k / halves}, s_.plunge, 1);
    }
  }

  /// Descends along the path itself, in several rounds.
  void descend(const Path& path, double from) {
    const double slope = std::tan(s_.ramp_angle), bottom = path.points.front().at.z(), length = path.length();
    // Whole rounds, so that the cut starts at the path's start.
    const int rounds = std::max(1, static_cast<int>(std::ceil((from - bottom) / slope / length)));
    double done = 0;
    const std::size_t n = path.points.size();
    for (int round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < n; ++i) {
        const PathPoint &a = path.points[i], &b = path.points[(i + 1) % n];
        done += length_between(a.at, b.at, a.bulge);
        const double share = std::min(1.0, done / (rounds * length));
        cut({b.at.x(), b.at.y(), share > 1 - 1e-9 ? bottom : from + share * (bottom - from)}, s_.plunge, a.bulge);
      }
  }

  void follow(const Path& path) {
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) step(path.points[i], path.points[i + 1]);
    if (path.closed) step(path.points.back(), path.points.front());
  }
  void step(const PathPoint& a, const PathPoint& b) {
    const Vec3 way = b.at - a.at;
    axis_ = b.axis;
    const bool down = a.bulge == 0 && -way.z() > 2 * way.head<2>().norm();
    cut(b.at, down || a.pace == Pace::enter ? s_.plunge : a.pace == Pace::link ? s_.link_feed : s_.feed, a.bulge);
  }

  const LinkSettings& s_;
  std::vector<Move> moves_;
  Vec3 axis_ = Vec3::UnitZ();  // axis of the tool at its next position
};

}  // namespace

std::vector<Move> link(const std::vector<Path>& paths, const LinkSettings& settings) {
  Linker linker(settings);
  for (const Path& path : paths) linker.add(path);
  return linker.take();
}

namespace {

/// Direction of a move at its start (share 0) or end (share 1).
Vec3 direction(const Vec3& from, const Move& m, double share) {
  Vec3 chord = m.to - from;
  if (m.bulge != 0) {
    const double turn = 2 * std::atan(m.bulge) * (share > 0 ? 1 : -1);
    chord = Vec3(std::cos(turn) * chord.x() - std::sin(turn) * chord.y(),
                 std::sin(turn) * chord.x() + std::cos(turn) * chord.y(), chord.z());
  }
  const double length = chord.norm();
  return length > 0 ? Vec3(chord / length) : Vec3::Zero();
}

}  // namespace

Lengths lengths(const std::vector<Move>& moves) {
  Lengths sum;
  for (std::size_t i = 1; i < moves.size(); ++i)
    (moves[i].rapid() ? sum.rapid : sum.cut) += length_between(moves[i - 1].to, moves[i].to, moves[i].bulge);
  return sum;
}

double duration(const std::vector<Move>& moves, const Dynamics& d) {
  const std::size_t n = moves.size();
  if (n < 2) return 0;
  // Speed at each joint: the corner's limit, then limits by braking (backward pass) and by
  // acceleration (forward pass).
  std::vector<double> limit(n, 0.0), length(n, 0.0), speed(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    length[i] = length_between(moves[i - 1].to, moves[i].to, moves[i].bulge);
    speed[i] = (moves[i].rapid() ? d.rapid : std::min(moves[i].feed, d.rapid)) / 60;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double cosine =
        std::clamp(direction(moves[i - 1].to, moves[i], 1).dot(direction(moves[i].to, moves[i + 1], 0)), -1.0, 1.0);
    // A circle that cuts the corner by d.corner, at the available acceleration.
    const double half = std::sqrt((1 + cosine) / 2), radius = half < 1 - 1e-12 ? d.corner * half / (1 - half) : 1e12;
    limit[i] = std::min({speed[i], speed[i + 1], std::sqrt(d.acceleration * radius)});
  }
  for (std::size_t i = n - 1; i-- > 1;)
    limit[i] = std::min(limit[i], std::sqrt(limit[i + 1] * limit[i + 1] + 2 * d.acceleration * length[i + 1]));
  for (std::size_t i = 1; i < n; ++i)
    limit[i] = std::min(limit[i], std::sqrt(limit[i - 1] * limit[i - 1] + 2 * d.acceleration * length[i]));
  double seconds = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (length[i] <= 0) continue;
    const double a = limit[i - 1], b = limit[i], v = speed[i], acceleration = d.acceleration;
    const double ramps = (2 * v * v - a * a - b * b) / (2 * acceleration);
    if (ramps <= length[i]) {
      seconds += (2 * v - a - b) / acceleration + (length[i] - ramps) / v;
    } else {
      const double peak = std::sqrt((2 * acceleration * length[i] + a * a + b * b) / 2);
      seconds += (2 * peak - a - b) / acceleration;
    }
  }
  return seconds;
}

}  // namespace fieldfab::cam
