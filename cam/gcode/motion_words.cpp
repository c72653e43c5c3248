#include "motion_words.h"

#include <cmath>

#include "threads.h"

namespace fieldfab::cam::gcode {
namespace {

bool has_axes(const Block& block) { return block.has_any(axis_letters) || block.has_radius || block.has_angle; }

/// Whether another code of the block than that of its motion uses the axis words.
bool axes_are_taken(const Block& block) {
  const int action = block.code(GGroup::action);
  return action == 100 || action == 280 || action == 300 || action == 520 || action == 920 ||
         block.code(GGroup::length) == 431 || block.code(GGroup::rotation) == 680;
}

bool is_arc(int code) { return code == 20 || code == 30; }

}  // namespace

void MotionWords::carry_out(const Block& block) {
  const int code = block.code(GGroup::motion), in_force = control_.modes.motion;
  const bool axes = has_axes(block);
  if (code == Block::none && (!axes || axes_are_taken(block))) {
    if (is_arc(in_force) && block.has_any("ijk")) arc(block, in_force);
    return;
  }
  const int used = code == Block::none ? in_force : code;
  if (nurbs_ && used != 52 && used != 53) refuse("{} between G5.2 and G5.3", g_name(used));
  if (!axes && !is_arc(used) && used != 800 && used != 52 && used != 53) {
    if (used != 0 && used != 10) refuse("{} needs axis words", g_name(used));
    control_.modes.motion = used;  // only sets the mode
    return;
  }
  if (used != 50) last_control_.reset();
  carry_out(block, used);
  if (used != 53) control_.modes.motion = used;
}

void MotionWords::carry_out(const Block& block, int code) {
  switch (code) {
    case 0:
    case 10: straight(block, code); break;
    case 20:
    case 30: arc(block, code); break;
    case 50:
    case 51: spline(block, code); break;
    case 52: nurbs_point(block); break;
    case 53: nurbs_end(); break;
    case 330:
    case 331: spindle_synchronous(block, code); break;
    case 382:
    case 383:
    case 384:
    case 385: probe(block); break;
    case 760: thread(block); break;
    case 800: break;
    default:
      if (Cycles::is_cycle(code)) cycles_.carry_out(block, code);
      break;
  }
}

void MotionWords::straight(const Block& block, int code) {
  if (code == 10) control_.require_feed(block);
  stream_.straight(code == 0 ? Motion::Kind::rapid : Motion::Kind::feed,
                   block.machine_coordinates ? machine_target(block) : control_.target(block));
}

/// G53: the words are axis positions; an axis without a word does not move.
AxisValues MotionWords::machine_target(const Block& block) const {
  stream_.no_compensation("G53");
  if (control_.frame.turned) refuse("G53 cannot be used while G68 is in force");
  if (!control_.modes.absolute) refuse("G53 needs G90");
  AxisValues axes = control_.frame.axes(control_.at);
  for (std::size_t k = 0; k < axis_letters.size(); ++k)
    if (block.has(axis_letters[k])) axes.at[k] = control_.word(block, axis_letters[k]);
  return control_.frame.of_axes(axes);
}

void MotionWords::arc(const Block& block, int code) {
  const PlaneAxes axes = axes_of(control_.modes.plane);
  if (block.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  if (block.has('r') && !block.has(axis_letters[axes.first]) && !block.has(axis_letters[axes.second]) &&
      !block.has_radius && !block.has_angle)
    refuse("an arc with R and no place to end in its plane");
  if (control_.modes.feed_mode == 930 && !block.has('f')) refuse("under G93 each arc needs its F word");
  control_.require_feed(block);
  const AxisValues to = control_.target(block);
  const int direction = code == 30 ? 1 : -1;
  Block words = block;
  if (control_.dialect != Dialect::linuxcnc)
    if (const std::string note = without_idle_offsets(words, control_.modes); !note.empty()) control_.note(note);
  stream_.arc(to, circle_of(words, control_.modes, direction, in_plane(control_.at, axes), in_plane(to, axes)));
}

/// G33 and G33.1: a feed of K per revolution.
void MotionWords::spindle_synchronous(const Block& block, int code) {
  const Modes& modes = control_.modes;
  stream_.no_compensation("G33");
  if (!block.has('k')) refuse("G33 needs K, the pitch");
  if (modes.spindle == 0 || modes.speed == 0) refuse("G33 while the spindle stands still");
  const AxisValues start = control_.at, to = control_.target(block);
  const double per_minute = std::abs(modes.length(block['k'])) * std::abs(modes.spindle_at(to));
  const auto go = [&](const AxisValues& place, double sign) {
    Motion motion = stream_.stamped(Motion::Kind::feed);
    motion.end = place;
    motion.feed = per_minute;
    motion.spindle *= sign;
    stream_.move(motion);
  };
  go(to, 1);
  if (code == 331) go(start, -1);  // the spindle reverses, and the tap retracts
}

void MotionWords::probe(const Block& block) {
  const AxisValues to = control_.target(block);
  stream_.no_compensation("G38");
  control_.require_feed(block);
  control_.note("G38: the probe is taken to touch nothing on its way");
  stream_.straight(Motion::Kind::feed, to);
  for (int k = 0; k < 9; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    control_.parameters.stored(number::probe_result + k) =
        axis >= 3 && axis < 6 ? to.at[axis] : to.at[axis] / control_.modes.unit();
  }
  control_.parameters.stored(number::probe_success) = 0;
}

void MotionWords::go_home(const Block& block, int first) {
  stream_.no_compensation("G28");
  if (control_.frame.turned) refuse("G28 and G30 cannot be used while G68 is in force");
  AxisValues home;
  for (int k = 0; k < 9; ++k) home.at[static_cast<std::size_t>(k)] = control_.parameters.stored(first + k);
  home = control_.frame.of_axes(home);
  const AxisValues by = control_.target(block);
  if (block.has_any(axis_letters)) {
    stream_.straight(Motion::Kind::rapid, by);
    for (std::size_t k = 0; k < 9; ++k)
      if (!block.has(axis_letters[k])) home.at[k] = by.at[k];
  }
  stream_.straight(Motion::Kind::rapid, home);
}

/// A chord of a spline.
void MotionWords::feed_along(const Vec2& place) {
  AxisValues next = control_.at;
  next.at[0] = place.x(), next.at[1] = place.y();
  stream_.chord(next);
}

/// G5 (cubic) and G5.1 (quadratic).
void MotionWords::spline(const Block& block, int code) {
  const Modes& modes = control_.modes;
  stream_.no_compensation("G5");
  if (modes.plane != ArcPlane::xy) refuse("splines are of the plane G17");
  if (block.has_any("zabcuvw")) refuse("a spline moves X and Y only");
  if (block.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  control_.require_feed(block);
  const AxisValues to = control_.target(block);
  const Vec2 begin{control_.at.at[0], control_.at.at[1]}, end{to.at[0], to.at[1]};
  const auto offset = [&](char first, char second) {
    return Vec2(modes.length(block[first]), modes.length(block[second]));
  };
  std::array<Vec2, 4> p;
  p[0] = begin, p[3] = end;
  if (code == 51) {
    if (!block.has('i') || !block.has('j')) refuse("G5.1 needs I and J");
    const Vec2 middle = begin + offset('i', 'j');
    p[1] = begin + (middle - begin) * (2.0 / 3), p[2] = end + (middle - end) * (2.0 / 3);
    last_control_.reset();
  } else {
    if (!block.has('p') || !block.has('q')) refuse("G5 needs P and Q");
    if (block.has('i') != block.has('j')) refuse("G5 needs both I and J, or neither");
    if (block.has('i'))
      p[1] = begin + offset('i', 'j');
    else if (last_control_)
      p[1] = 2 * begin - *last_control_;
    else
      refuse("the first G5 of a row needs I and J");
    p[2] = end + offset('p', 'q');
    last_control_ = p[2];
  }
  flatten(p, [this](const Vec2& place) { feed_along(place); });
}

/// G5.2 and the lines after it: control points of a NURBS curve. The first one is the tool's position.
void MotionWords::nurbs_point(const Block& block) {
  stream_.no_compensation("G5.2");
  if (control_.modes.plane != ArcPlane::xy) refuse("splines are of the plane G17");
  if (block.has_any("zabcuvw") || block.machine_coordinates) refuse("a NURBS moves X and Y only");
  if (!nurbs_) {
    control_.require_feed(block);
    nurbs_.emplace(Vec2(control_.at.at[0], control_.at.at[1]));
  }
  if (block.has('l')) nurbs_->set_order(whole(block['l']));
  const double weight = block.has('p') ? block['p'] : 1;
  if (!(weight > 0)) refuse("a control point with the weight {}", weight);
  if (!block.has('x') && !block.has('y')) return nurbs_->set_first_weight(weight);
  if (!block.has('p')) refuse("each control point needs its weight P, above 0");
  if (!block.has('x') || !block.has('y')) refuse("each control point needs both X and Y");
  const AxisValues to = control_.target(block);
  nurbs_->add({to.at[0], to.at[1]}, weight);
}

void MotionWords::nurbs_end() {
  if (!nurbs_) refuse("G5.3 without G5.2");
  const Nurbs curve = *std::exchange(nurbs_, std::nullopt);
  control_.modes.motion = 800;
  curve.flatten([this](const Vec2& place) { feed_along(place); });
}

/// G76.
void MotionWords::thread(const Block& block) {
  const Modes& modes = control_.modes;
  stream_.no_compensation("G76");
  for (const char letter : {'p', 'z', 'i', 'j', 'k'})
    if (!block.has(letter)) refuse("G76 needs {}", static_cast<char>(letter - 32));
  if (block.has_any("xyabcuvw")) refuse("G76 takes no axis word but Z");
  if (modes.spindle == 0 || modes.speed == 0) refuse("G76 while the spindle stands still");
  const AxisValues start = control_.at;
  const double half = modes.diameter ? 0.5 : 1;  // I, J and K are diameters under G7
  Thread thread;
  thread.x = start.at[0];
  thread.start = start.at[2];
  thread.pitch = modes.length(block['p']);
  thread.peak = modes.length(block['i']) * half;
  thread.first_cut = modes.length(block['j']) * half;
  thread.full = modes.length(block['k']) * half;
  thread.degression = block.has('r') ? block['r'] : 1;
  thread.slant = block.has('q') ? block['q'] : 0;
  thread.taper = block.has('e') ? modes.length(block['e']) : 0;
  thread.springs = block.has('h') ? whole(block['h'], 10'000) : 0;
  const int ends = block.has('l') ? whole(block['l']) : 0;
  if (thread.pitch <= 0 || thread.peak == 0 || thread.first_cut <= 0)
    refuse("G76 needs P and J above 0, and I other than 0");
  if (thread.full <= thread.first_cut) refuse("G76: K, the full depth, must be more than J, the first cut's");
  if (thread.degression < 1) refuse("G76 with R{}: it must be 1 or more", thread.degression);
  if (thread.slant < 0 || thread.slant > 80)
    refuse("G76 with Q{}: the slant is between 0 and 80 degrees", thread.slant);
  if (thread.springs < 0 || ends < 0 || ends > 3) refuse("G76 with a bad H or L");
  thread.entry = (ends & 1) != 0, thread.exit = (ends & 2) != 0;
  thread.end = control_.target(block).at[2];
  if (thread.taper < 0 || (ends == 3 ? 2 : 1) * thread.taper > std::abs(thread.end - thread.start))
    refuse("G76 with E beyond the thread's length");

  const double speed = std::abs(modes.spindle_at(start));
  const auto go = [&](const ThreadMove& move) {
    Motion motion = stream_.stamped(move.pitch > 0 ? Motion::Kind::feed : Motion::Kind::rapid);
    motion.end = start;
    motion.end.at[0] = move.x, motion.end.at[2] = move.z;
    motion.feed = move.pitch * speed;
    stream_.move(motion);
  };
  cut_thread(thread, go, [this] { count_.add(); });
}

}  // namespace fieldfab::cam::gcode
