#include "compensation.h"

#include <cmath>
#include <numbers>

#include "frame.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr double straight_within = 0.05;  // radians: smaller corners are ignored
constexpr double nowhere = 1e-9;          // mm

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }
double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Signed angle between two directions; positive is a turn to the left.
double angle_between(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), from.dot(to)); }

[[noreturn]] void unreachable() { refuse("an inner corner that the tool cannot reach without gouging"); }

}  // namespace

std::optional<std::array<Vec2, 2>> intersections(const Track& a, const Track& b) {
  std::array<Vec2, 2> places;
  if (a.circle && b.circle) {
    const Vec2 way = b.point - a.point;
    const double distance = way.norm();
    const double along =
        distance > 0 ? (a.radius * a.radius - b.radius * b.radius + distance * distance) / (2 * distance) : 0;
    const double aside = a.radius * a.radius - along * along;
    if (distance < nowhere || aside < 0) return std::nullopt;
    const Vec2 unit = way / distance;
    for (std::size_t i = 0; i < 2; ++i)
      places[i] = a.point + unit * along + left_of(unit) * (i == 0 ? 1 : -1) * std::sqrt(aside);
    return places;
  }
  const Track& line = a.circle ? b : a;
  const Track& circle = a.circle ? a : b;
  const double along = (circle.point - line.point).dot(line.direction),
               away = cross(line.direction, circle.point - line.point);
  const double aside = circle.radius * circle.radius - away * away;
  if (aside < 0) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i)
    places[i] = line.point + line.direction * (along + (i == 0 ? 1 : -1) * std::sqrt(aside));
  return places;
}

void Compensation::start(int side, double radius, const AxisValues& position) {
  side_ = side;
  radius_ = radius;
  begin_at(position);
}

void Compensation::stop() {
  pass_on_waiting();
  side_ = 0;
}

void Compensation::give(const Motion& motion) {
  if (!on()) return next_(motion);
  switch (motion.kind) {
    case Motion::Kind::rapid:
    case Motion::Kind::feed: return straight(motion);
    case Motion::Kind::arc: return arc(motion);
    default: {
      Motion here = motion;
      here.end = centre_;
      pass_on_or_wait(std::move(here));
    }
  }
}

/// The tool's centre at a point of the path with a heading.
Vec2 Compensation::beside(const Vec2& at, const Vec2& heading) const {
  return at + left_of(heading) * (side_ * radius_);
}

void Compensation::pass_on_waiting() {
  std::deque<Motion> waiting;
  waiting.swap(waiting_);
  for (const Motion& motion : waiting) next_(motion);
}

/// Passes a motion on, or appends it to the waiting ones until their corner is known.
void Compensation::pass_on_or_wait(Motion motion) {
  if (waiting_.empty())
    next_(motion);
  else
    waiting_.push_back(std::move(motion));
}

/// Passes on the waiting motions and keeps this move of the plane in their place.
void Compensation::wait(Motion motion, const Vec2& heading) {
  pass_on_waiting();
  start_ = in_plane(centre_, axes_of(motion.plane));
  heading_ = heading;
  centre_ = motion.end;
  waiting_.push_back(std::move(motion));
}

void Compensation::straight(Motion motion) {
  const PlaneAxes axes = axes_of(motion.plane);
  const Vec2 begin = in_plane(programmed_, axes), end = in_plane(motion.end, axes);
  const double way = (end - begin).norm();
  programmed_ = motion.end;
  if (way < nowhere) {  // a move across the plane
    set_in_plane(motion.end, axes, in_plane(centre_, axes));
    centre_ = motion.end;
    return pass_on_or_wait(std::move(motion));
  }
  const Vec2 heading = (end - begin) / way;
  if (!waiting_.empty())
    corner(begin, heading, {false, beside(begin, heading), heading, 0}, motion);
  else if (way <= radius_)
    refuse("the entry move of cutter compensation is not longer than the tool's radius");
  set_in_plane(motion.end, axes, beside(end, heading));
  wait(std::move(motion), heading);
}

void Compensation::arc(Motion motion) {
  const PlaneAxes axes = axes_of(motion.plane);
  const Vec2 begin = in_plane(programmed_, axes), end = in_plane(motion.end, axes), centre = motion.centre;
  const int direction = motion.turns > 0 ? 1 : -1;
  const double radius = (end - centre).norm();
  const Vec2 leaving = left_of(begin - centre).normalized() * direction,
             arriving = left_of(end - centre) / radius * direction;
  const bool inside = direction == side_;
  if (inside && radius <= radius_) refuse("an arc whose radius is not more than the tool's");
  programmed_ = motion.end;
  const Vec2 place = beside(end, arriving);
  if (waiting_.empty()) {
    // Entry arc from the tool's position, tangent to the path's direction at its end.
    const Vec2 way = place - begin, inward = (centre - end) / radius;
    const double along = way.dot(inward);
    if (std::abs(along) < nowhere) refuse("the entry arc of cutter compensation cannot be made");
    motion.centre = place - inward * (way.squaredNorm() / (2 * along));
  } else {
    // The two radii of an arc differ by rounding. The choice follows LinuxCNC, because nearly tangent tracks amplify
    // the difference.
    const bool behind_arc = waiting_.front().kind == Motion::Kind::arc;
    const double track = behind_arc ? radius : (begin - centre).norm();
    corner(begin, leaving, {true, centre, {}, track + (inside ? -radius_ : radius_)}, motion);
  }
  set_in_plane(motion.end, axes, place);
  wait(std::move(motion), arriving);
}

/// The corner between the waiting move and `motion`, which leaves with `heading` on the track `next`.
void Compensation::corner(const Vec2& at, const Vec2& heading, const Track& next, const Motion& motion) {
  if (radius_ == 0) return;
  const double turn = angle_between(heading_, heading) * side_;
  if (std::abs(turn) < straight_within) return;
  if (turn < 0 || std::numbers::pi - turn < straight_within)  // a reversal counts as an outer corner
    outer_corner(at, heading, motion);
  else
    inner_corner(at, turn, next);
}

/// The tool goes around an outer corner along an arc (along a straight move before a rapid).
void Compensation::outer_corner(const Vec2& at, const Vec2& heading, const Motion& motion) {
  const PlaneAxes axes = axes_of(motion.plane);
  Motion around = motion;  // axes other than the third move during the corner's arc
  around.end.at[axes.third] = centre_.at[axes.third];
  set_in_plane(around.end, axes, beside(at, heading));
  const bool rapid = motion.kind == Motion::Kind::rapid;
  around.kind = rapid ? Motion::Kind::rapid : Motion::Kind::arc;
  around.centre = rapid ? Vec2(Vec2::Zero()) : at;
  around.turns = rapid ? 0 : -side_;
  wait(std::move(around), heading);
}

/// At an inner corner the waiting move ends at the intersection of the tracks.
void Compensation::inner_corner(const Vec2& at, double turn, const Track& next) {
  const Motion& before = waiting_.front();
  const PlaneAxes axes = axes_of(before.plane);
  const Vec2 from = beside(at, heading_);  // end of the waiting move without the corner
  const bool arc = before.kind == Motion::Kind::arc;
  Vec2 meet = from;
  if (!arc && !next.circle) {
    const double back = radius_ * std::tan(turn / 2);
    if (back > (from - start_).norm() + 1e-9) unreachable();
    meet = from - heading_ * back;
  } else {
    const Track last{arc, arc ? before.centre : from, heading_, (from - before.centre).norm()};
    const auto places = intersections(last, next);
    if (!places) unreachable();
    const auto& [a, b] = *places;
    meet = (a - from).norm() < (b - from).norm() ? a : b;
    if (!arc && (meet - start_).dot(heading_) < -1e-9) unreachable();
  }
  for (Motion& motion : waiting_) set_in_plane(motion.end, axes, meet);
  set_in_plane(centre_, axes, meet);
}

}  // namespace fieldfab::cam::gcode
