// Straight moves, and the processing that all motions share.
#include <cmath>
#include <numbers>

#include "base/chords.h"
#include "fieldfab/core/angle.h"
#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr std::string_view letters = "xyzabcuvw";
constexpr double chord_tolerance = 0.001;  // mm, for arcs that become short feeds

double distance(const AxisValues& a, const AxisValues& b, std::size_t first, std::size_t count) {
  double sum = 0;
  for (std::size_t k = first; k < first + count; ++k) sum += (b.at[k] - a.at[k]) * (b.at[k] - a.at[k]);
  return std::sqrt(sum);
}

}  // namespace

double Interpreter::word(char letter) const {
  const double value = block_[letter];
  if (letter >= 'a' && letter <= 'c') return value;
  return length(letter == 'x' && modes_.diameter ? value / 2 : value);
}

AxisValues Interpreter::target() const {
  const AxisValues& from = compensation_.side != 0 && compensation_.entered ? compensation_.programmed : at_;
  AxisValues to = from;
  for (std::size_t k = 0; k < letters.size(); ++k)
    if (block_.has(letters[k])) to.at[k] = modes_.absolute ? word(letters[k]) : from.at[k] + word(letters[k]);
  if (block_.has_radius || block_.has_angle) {
    if (block_.has('x') || block_.has('y')) refuse("@ and ^ do not go with X and Y");
    if (modes_.plane != ArcPlane::xy) refuse("@ and ^ are of the plane G17");
    double radius = std::hypot(from.at[0], from.at[1]), angle = std::atan2(from.at[1], from.at[0]);
    if (block_.has_angle && !block_.has_radius && radius == 0) refuse("^ without @ at the origin");
    if (block_.has_radius) radius = modes_.absolute ? length(block_.radius) : radius + length(block_.radius);
    if (block_.has_angle)
      angle = modes_.absolute ? block_.angle * radians_per_degree : angle + block_.angle * radians_per_degree;
    to.at[0] = radius * std::cos(angle);
    to.at[1] = radius * std::sin(angle);
  }
  return to;
}

/// G53: the words are axis positions; an axis without a word does not move.
AxisValues Interpreter::machine_target() const {
  if (compensation_.side != 0) refuse("G53 cannot be used while cutter compensation is on");
  if (frame_.turned) refuse("G53 cannot be used while G68 is in force");
  if (!modes_.absolute) refuse("G53 needs G90");
  AxisValues axes = frame_.axes(at_);
  for (std::size_t k = 0; k < letters.size(); ++k)
    if (block_.has(letters[k])) axes.at[k] = word(letters[k]);
  return frame_.of_axes(axes);
}

void Interpreter::require_feed() {
  if (modes_.feed_mode == 930) {
    if (!block_.has('f') || modes_.feed <= 0) refuse("under G93 each feed needs its F word, above 0");
  } else if (modes_.feed <= 0 && options_.dialect != Dialect::linuxcnc) {
    notes_.add(flow_.line(), "a feed without a feed rate (F): its time is not counted");
  } else if (modes_.feed <= 0) {
    refuse("a feed without a feed rate: F is missing or 0");
  } else if (modes_.feed_mode == 950 && modes_.speed == 0) {
    refuse("a feed per revolution (G95) while the spindle's speed is 0");
  }
}

void Interpreter::motion() {
  const int code = block_.code(GGroup::motion), action = block_.code(GGroup::action);
  const bool axes = block_.has_any(letters) || block_.has_radius || block_.has_angle;
  const bool taken = action == 100 || action == 280 || action == 300 || action == 520 || action == 920 ||
                     block_.code(GGroup::length) == 431 || block_.code(GGroup::rotation) == 680;
  if (code == Block::none && (!axes || taken)) {
    if (modes_.motion == 20 || modes_.motion == 30) {
      if (block_.has_any("ijk")) {
        arc();
        return;
      }
    }
    return;
  }
  const int used = code == Block::none ? modes_.motion : code;
  if (nurbs_order_ != 0 && used != 52 && used != 53) refuse("{} between G5.2 and G5.3", g_name(used));
  const bool is_cycle = used >= 730 && used <= 890 && used != 760 && used != 800;
  if (!axes && used != 20 && used != 30 && used != 800 && used != 52 && used != 53) {
    if (used == 0 || used == 10) {  // only sets the mode
      modes_.motion = used;
      return;
    }
    refuse("{} needs axis words", g_name(used));
  }
  if (used != 50) last_control_.reset();
  switch (used) {
    case 0:
    case 10:
      if (used == 10) require_feed();
      straight(block_.machine_coordinates ? machine_target() : target());
      break;
    case 20:
    case 30: arc(); break;
    case 50:
    case 51: spline(); break;
    case 52: nurbs_point(); break;
    case 53: nurbs_end(); break;
    case 330:
    case 331: spindle_synchronous(); break;
    case 382:
    case 383:
    case 384:
    case 385: probe(target()); break;
    case 760: thread(); break;
    case 800: break;
    default:
      if (is_cycle) cycle();
      break;
  }
  if (used == 53) return;
  modes_.motion = used;
}

void Interpreter::straight(const AxisValues& to) {
  const int code = block_.code(GGroup::motion) == Block::none ? modes_.motion : block_.code(GGroup::motion);
  const auto kind = code == 0 ? Motion::Kind::rapid : Motion::Kind::feed;
  if (compensation_.side != 0)
    compensated_straight(kind, to);
  else
    move(kind, to);
}

/// G33 and G33.1: a feed of K per revolution.
void Interpreter::spindle_synchronous() {
  no_compensation("G33");
  if (!block_.has('k')) refuse("G33 needs K, the pitch");
  if (modes_.spindle == 0 || modes_.speed == 0) refuse("G33 while the spindle stands still");
  const int code = block_.code(GGroup::motion) == Block::none ? modes_.motion : block_.code(GGroup::motion);
  const AxisValues start = at_, to = target();
  const double per_minute = std::abs(length(block_['k'])) * std::abs(spindle_at(to));
  const auto go = [&](const AxisValues& place, double sign) {
    Motion motion = stamped(Motion::Kind::feed);
    motion.end = place;
    motion.feed = per_minute;
    motion.spindle *= sign;
    give(motion);
    at_ = place;
  };
  go(to, 1);
  if (code == 331) go(start, -1);  // the spindle reverses, and the tap retracts
}

void Interpreter::probe(const AxisValues& to) {
  no_compensation("G38");
  require_feed();
  notes_.add(flow_.line(), "G38: the probe is taken to touch nothing on its way");
  move(Motion::Kind::feed, to);
  for (int k = 0; k < 9; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    parameters_.stored(number::probe_result + k) = axis >= 3 && axis < 6 ? to.at[axis] : to.at[axis] / unit();
  }
  parameters_.stored(number::probe_success) = 0;
}

double Interpreter::spindle_at(const AxisValues& to) const {
  double speed = modes_.speed;
  if (modes_.constant_surface) {
    // S is in m/min (feet/min under G20); X is the radius.
    const double around = 2 * std::numbers::pi * std::abs(to.at[0]), surface = speed * (modes_.inch ? 304.8 : 1000);
    speed = modes_.most_speed > 0 ? modes_.most_speed : 1e5;
    if (around > 0) speed = std::min(speed, surface / around);
  }
  return speed * modes_.spindle;
}

Motion Interpreter::stamped(Motion::Kind kind) const {
  Motion motion;
  motion.kind = kind;
  motion.plane = modes_.plane;
  motion.mode = mode_;
  motion.line = flow_.line();
  motion.tool = tool_;
  motion.spindle = spindle_at(at_);
  motion.tool_offset = frame_.tool.xyz();
  return motion;
}

void Interpreter::feed_of(Motion& motion, const AxisValues& from, double length_along) const {
  const double xyz = length_along >= 0 ? length_along : distance(from, motion.end, 0, 3);
  const double uvw = distance(from, motion.end, 6, 3), turn = distance(from, motion.end, 3, 3) * radians_per_degree;
  if (modes_.feed_mode == 930) {
    const double along = xyz > 0 ? xyz : uvw > 0 ? uvw : turn;
    motion.feed = modes_.feed * (along > 0 ? along : 1);
    motion.seconds = -1;  // send() computes it, with the length of the motion
    return;
  }
  const bool rotary = xyz == 0 && uvw == 0 && turn > 0;
  motion.feed = modes_.feed * (rotary ? radians_per_degree : modes_.feed_unit);
  if (modes_.feed_mode == 950) motion.feed *= std::abs(modes_.spindle == 0 ? modes_.speed : spindle_at(motion.end));
}

void Interpreter::move(Motion::Kind kind, const AxisValues& to, double length_along) {
  Motion motion = stamped(kind);
  motion.end = to;
  motion.spindle = spindle_at(to);
  if (kind == Motion::Kind::feed) feed_of(motion, at_, length_along);
  at_ = to;
  give(motion);
}

void Interpreter::move_arc(const AxisValues& to, const Vec2& centre, int turns) {
  Motion motion = stamped(Motion::Kind::arc);
  motion.end = to;
  motion.centre = centre;
  motion.turns = turns;
  const PlaneAxes axes = axes_of(modes_.plane);
  const Vec2 from{at_.at[axes.first], at_.at[axes.second]}, end{to.at[axes.first], to.at[axes.second]};
  feed_of(motion, at_, std::hypot(arc_length(from, end, centre, turns), to.at[axes.third] - at_.at[axes.third]));
  at_ = to;
  give(motion);
}

/// Hands a motion to the sink, or appends it to the pending ones until their corner is known.
void Interpreter::give(Motion motion) {
  if (!compensation_.waiting.empty())
    compensation_.waiting.push_back(std::move(motion));
  else
    send(std::move(motion));
}

/// Converts a motion to machine coordinates and sends it.
void Interpreter::send(Motion motion) {
  const AxisValues to = motion.end;
  for (const double value : to.at)
    if (!(std::abs(value) < 1e12)) refuse("a move to {}, which no machine can reach", value);
  const PlaneAxes axes = axes_of(motion.plane);
  const bool arc = motion.kind == Motion::Kind::arc;
  if (motion.seconds < 0) {  // under G93
    double along = distance(sent_, to, 0, 3);
    if (arc) {
      const Vec2 from{sent_.at[axes.first], sent_.at[axes.second]}, end{to.at[axes.first], to.at[axes.second]};
      along = std::hypot(arc_length(from, end, motion.centre, motion.turns), to.at[axes.third] - sent_.at[axes.third]);
    }
    if (along == 0) along = distance(sent_, to, 6, 3);
    if (along == 0) along = distance(sent_, to, 3, 3) * radians_per_degree;
    motion.seconds = 60 * along / motion.feed;
  }
  if (arc && !frame_.keeps(motion.plane)) return send_chords(motion);
  motion.end = frame_.tip(to);
  for (std::size_t k = 3; k < 6; ++k) motion.end.at[k] *= radians_per_degree;
  if (arc) {
    AxisValues centre = to;
    centre.at[axes.first] = motion.centre.x(), centre.at[axes.second] = motion.centre.y();
    centre = frame_.tip(centre);
    motion.centre = {centre.at[axes.first], centre.at[axes.second]};
  }
  sent_ = to;
  sink_(motion);
}

/// Short feeds for an arc that the frame rotates out of its plane.
void Interpreter::send_chords(const Motion& arc) {
  notes_.add(arc.line, "an arc in a plane that the rotation in force does not keep: given as short straight feeds");
  const PlaneAxes axes = axes_of(arc.plane);
  const AxisValues from = sent_;
  const Vec2 begin = Vec2(from.at[axes.first], from.at[axes.second]) - arc.centre;
  const Vec2 end = Vec2(arc.end.at[axes.first], arc.end.at[axes.second]) - arc.centre;
  const double radius = begin.norm(), radius_end = end.norm();
  const double sweep =
      arc_length(begin, end, Vec2::Zero(), arc.turns) / std::max(radius, 1e-9) * (arc.turns > 0 ? 1 : -1);
  const double step = chord_angle(radius, chord_tolerance);
  const int count = std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / std::max(step, 1e-4))), 1, 1'000'000);
  const double start_angle = std::atan2(begin.y(), begin.x());
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count, angle = start_angle + share * sweep;
    Motion motion = arc;
    motion.kind = Motion::Kind::feed;
    motion.turns = 0;
    motion.centre = Vec2::Zero();
    if (arc.seconds > 0) motion.seconds = arc.seconds / count;
    for (std::size_t k = 0; k < 9; ++k) motion.end.at[k] = from.at[k] + share * (arc.end.at[k] - from.at[k]);
    const double r = radius + share * (radius_end - radius);
    if (i < count) {
      motion.end.at[axes.first] = arc.centre.x() + r * std::cos(angle);
      motion.end.at[axes.second] = arc.centre.y() + r * std::sin(angle);
    }
    send(motion);
  }
}

}  // namespace fieldfab::cam::gcode
