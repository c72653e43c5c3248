#include "motion_stream.h"

namespace fieldfab::cam::gcode {

MotionStream::MotionStream(Control& control, MotionSink sink)
    : control_(control),
      machine_(control.frame, control.at, control.notes, std::move(sink)),
      compensation_([this](const Motion& motion) { machine_.give(motion); }) {}

void MotionStream::no_compensation(std::string_view what) const {
  if (compensation_.on()) refuse("{} cannot be used while cutter compensation is on", what);
}

Motion MotionStream::stamped(Motion::Kind kind) const {
  Motion motion;
  motion.kind = kind;
  motion.plane = control_.modes.plane;
  motion.mode = control_.mode;
  motion.line = control_.line;
  motion.end = position();
  motion.tool = control_.tool;
  motion.spindle = control_.modes.spindle_at(position());
  motion.tool_offset = control_.frame.tool.xyz();
  return motion;
}

void MotionStream::straight(Motion::Kind kind, const AxisValues& to) {
  Motion motion = stamped(kind);
  motion.end = to;
  // Under G96 the speed is that at the end; with compensation that at the start, because the end is not known yet.
  if (!compensation_.on()) motion.spindle = control_.modes.spindle_at(to);
  if (kind == Motion::Kind::feed) control_.modes.set_feed(motion, control_.at);
  move(motion);
}

void MotionStream::arc(const AxisValues& to, const Circle& circle) {
  Motion motion = stamped(Motion::Kind::arc);
  motion.end = to;
  motion.centre = circle.centre;
  motion.turns = circle.turns;
  control_.modes.set_feed(motion, control_.at);
  move(motion);
}

void MotionStream::move(const Motion& motion) {
  control_.at = motion.end;
  compensation_.give(motion);
}

void MotionStream::chord(const AxisValues& to) {
  Motion motion = stamped(Motion::Kind::feed);
  motion.end = to;
  motion.spindle = control_.modes.spindle_at(to);
  control_.modes.set_feed(motion, control_.at);
  control_.at = to;
  compensation_.begin_at(to);  // for G41 between G5.2 and G5.3
  machine_.give(motion);
}

void MotionStream::dwell(double seconds) {
  if (seconds < 0) refuse("a dwell of {} seconds", seconds);
  Motion motion = stamped(Motion::Kind::dwell);
  motion.seconds = seconds;
  compensation_.give(motion);
}

void MotionStream::change_frame(const Frame& next) {
  machine_.change_frame(next);
  control_.at = next.of_axes(control_.frame.axes(control_.at));
  control_.frame = next;
}

}  // namespace fieldfab::cam::gcode
