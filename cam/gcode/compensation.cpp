// Cutter compensation, G41, G42 and their .1: the tool's centre follows the path at the distance of
// its radius. A move is kept until the next one is known, because in an inner corner it ends before
// the programmed end.
#include <cmath>
#include <numbers>

#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr double straight_within = 0.05;  // radians: smaller corners are ignored
constexpr double nowhere = 1e-9;          // mm

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }
double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Signed angle between two directions; positive is a turn to the left.
double angle_between(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), from.dot(to)); }

}  // namespace

void Interpreter::set_compensation() {
  const int code = block_.code(GGroup::compensation);
  if (code == 400) {
    flush();
    // a missing word means the position on the path
    if (compensation_.side != 0 && compensation_.entered) at_ = compensation_.programmed;
    compensation_ = {};
    return;
  }
  if (modes_.plane == ArcPlane::yz) refuse("cutter compensation is of the planes G17 and G18");
  no_compensation(g_name(code).c_str());
  if (modes_.plane == ArcPlane::zx && frame_.rotation != 0)
    refuse("cutter compensation in G18 with a rotated coordinate system");
  double radius = 0;
  if (code == 411 || code == 421) {
    if (!block_.has('d')) refuse("{} needs D, the tool's diameter", g_name(code));
    radius = length(block_['d']) / 2;
  } else {
    const int tool = block_.has('d') ? whole(block_['d']) : tool_;
    if (tool < 0) refuse("D{} is below 0", tool);
    radius = tool_entry(tool == 0 ? tool_ : tool).diameter / 2;
  }
  compensation_ = {};
  compensation_.side = (code < 420 ? 1 : -1) * (radius < 0 ? -1 : 1);
  compensation_.radius = std::abs(radius);
  compensation_.programmed = at_;
}

/// The tool's centre at a point of the path with a heading.
Vec2 Interpreter::beside(const Vec2& at, const Vec2& heading) const {
  return at + left_of(heading) * (compensation_.side * compensation_.radius);
}

void Interpreter::flush() {
  std::deque<Motion> waiting;
  waiting.swap(compensation_.waiting);
  for (Motion& motion : waiting) send(std::move(motion));
}

/// Hands on the pending moves and keeps this move of the plane as pending.
void Interpreter::give_waiting(Motion motion, const Vec2& heading) {
  flush();
  const PlaneAxes axes = axes_of(motion.plane);
  compensation_.start = {at_.at[axes.first], at_.at[axes.second]};
  compensation_.heading = heading;
  compensation_.entered = true;
  at_ = motion.end;
  compensation_.waiting.push_back(std::move(motion));
}

/// The corner between the pending move and the next one, which leaves with `heading` on the track
/// `next`. An outer corner becomes an arc (a straight move for rapids); at an inner corner the
/// pending move ends at the intersection of the tracks.
void Interpreter::corner(const Vec2& at, const Vec2& heading, const Track& next, const Motion& pattern) {
  Compensation& comp = compensation_;
  const PlaneAxes axes = axes_of(modes_.plane);
  if (comp.waiting.empty() || comp.radius == 0) return;
  const double turn = angle_between(comp.heading, heading) * comp.side;
  if (std::abs(turn) < straight_within) return;
  if (turn < 0 || std::numbers::pi - turn < straight_within) {  // a reversal counts as an outer corner
    // axes other than the third move during the corner's arc
    Motion arc = pattern;
    if (pattern.kind != Motion::Kind::rapid) arc.kind = Motion::Kind::arc;
    arc.end.at[axes.third] = at_.at[axes.third];
    const Vec2 end = beside(at, heading);
    arc.end.at[axes.first] = end.x(), arc.end.at[axes.second] = end.y();
    arc.centre = arc.kind == Motion::Kind::arc ? at : Vec2(Vec2::Zero());
    arc.turns = arc.kind == Motion::Kind::arc ? -comp.side : 0;
    give_waiting(std::move(arc), heading);
    return;
  }
  Motion& before = comp.waiting.front();
  const Vec2 from = beside(at, comp.heading);  // end of the pending move without the corner
  Vec2 meet = from;
  const auto unreachable = [] { refuse("an inner corner that the tool cannot reach without gouging"); };
  if (before.kind != Motion::Kind::arc && !next.circle) {
    const double back = comp.radius * std::tan(turn / 2);
    if (back > (from - comp.start).norm() + 1e-9) unreachable();
    meet = from - comp.heading * back;
  } else {
    // The intersection of the tracks nearest to the corner.
    Track last;
    last.circle = before.kind == Motion::Kind::arc;
    last.point = last.circle ? before.centre : from;
    last.direction = comp.heading;
    last.radius = (from - before.centre).norm();
    std::array<Vec2, 2> places;
    if (last.circle && next.circle) {
      const Vec2 way = next.point - last.point;
      const double distance = way.norm();
      const double along =
          distance > 0 ? (last.radius * last.radius - next.radius * next.radius + distance * distance) / (2 * distance)
                       : 0;
      const double aside = last.radius * last.radius - along * along;
      if (distance < nowhere || aside < 0) unreachable();
      const Vec2 unit = way / distance;
      for (std::size_t i = 0; i < 2; ++i)
        places[i] = last.point + unit * along + left_of(unit) * (i == 0 ? 1 : -1) * std::sqrt(aside);
    } else {
      const Track& line = last.circle ? next : last;
      const Track& circle = last.circle ? last : next;
      const double along = (circle.point - line.point).dot(line.direction),
                   away = cross(line.direction, circle.point - line.point);
      const double aside = circle.radius * circle.radius - away * away;
      if (aside < 0) unreachable();
      for (std::size_t i = 0; i < 2; ++i)
        places[i] = line.point + line.direction * (along + (i == 0 ? 1 : -1) * std::sqrt(aside));
    }
    meet = (places[0] - from).norm() < (places[1] - from).norm() ? places[0] : places[1];
    if (!last.circle && (meet - comp.start).dot(comp.heading) < -1e-9) unreachable();
  }
  for (Motion& motion : comp.waiting) motion.end.at[axes.first] = meet.x(), motion.end.at[axes.second] = meet.y();
  at_.at[axes.first] = meet.x(), at_.at[axes.second] = meet.y();
}

void Interpreter::compensated_straight(Motion::Kind kind, const AxisValues& to) {
  Compensation& comp = compensation_;
  const PlaneAxes axes = axes_of(modes_.plane);
  const AxisValues from = comp.entered ? comp.programmed : at_;
  const Vec2 begin{from.at[axes.first], from.at[axes.second]}, end{to.at[axes.first], to.at[axes.second]};
  Motion motion = stamped(kind);
  motion.end = to;
  if (kind == Motion::Kind::feed) feed_of(motion, from, -1);
  const double way = (end - begin).norm();
  comp.programmed = to;
  if (way < nowhere) {
    motion.end.at[axes.first] = at_.at[axes.first], motion.end.at[axes.second] = at_.at[axes.second];
    at_ = motion.end;
    give(std::move(motion));
    return;
  }
  const Vec2 heading = (end - begin) / way, place = beside(end, heading);
  if (!comp.entered) {
    if (way <= comp.radius) refuse("the entry move of cutter compensation is not longer than the tool's radius");
  } else {
    corner(begin, heading, {false, beside(begin, heading), heading, 0}, motion);
  }
  motion.end.at[axes.first] = place.x(), motion.end.at[axes.second] = place.y();
  give_waiting(std::move(motion), heading);
}

void Interpreter::compensated_arc(const AxisValues& to, const Circle& circle) {
  Compensation& comp = compensation_;
  const PlaneAxes axes = axes_of(modes_.plane);
  const AxisValues from = comp.entered ? comp.programmed : at_;
  const Vec2 begin{from.at[axes.first], from.at[axes.second]}, end{to.at[axes.first], to.at[axes.second]};
  const int direction = circle.turns > 0 ? 1 : -1;
  const double radius = (end - circle.centre).norm();
  const Vec2 leaving = left_of(begin - circle.centre).normalized() * direction,
             arriving = left_of(end - circle.centre) / radius * direction;
  const bool inside = direction == comp.side;
  if (inside && radius <= comp.radius) refuse("an arc whose radius is not more than the tool's");
  Motion motion = stamped(Motion::Kind::arc);
  motion.end = to;
  motion.turns = circle.turns;
  motion.centre = circle.centre;
  feed_of(motion, from,
          std::hypot(arc_length(begin, end, circle.centre, circle.turns), to.at[axes.third] - from.at[axes.third]));
  comp.programmed = to;
  const Vec2 place = beside(end, arriving);
  if (!comp.entered) {
    // Entry arc from the tool's position, tangent to the path's direction at its end.
    const Vec2 way = place - begin, inward = (circle.centre - end) / radius;
    const double along = way.dot(inward);
    if (std::abs(along) < nowhere) refuse("the entry arc of cutter compensation cannot be made");
    motion.centre = place - inward * (way.squaredNorm() / (2 * along));
  } else {
    // The two radii of an arc differ by rounding. The choice follows LinuxCNC, because nearly
    // tangent tracks amplify the difference.
    const bool behind_arc = !comp.waiting.empty() && comp.waiting.front().kind == Motion::Kind::arc;
    const double track = behind_arc ? radius : (begin - circle.centre).norm();
    corner(begin, leaving, {true, circle.centre, {}, track + (inside ? -comp.radius : comp.radius)}, motion);
  }
  motion.end.at[axes.first] = place.x(), motion.end.at[axes.second] = place.y();
  give_waiting(std::move(motion), arriving);
}

}  // namespace fieldfab::cam::gcode
