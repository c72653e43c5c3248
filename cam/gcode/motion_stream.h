// The stream of motions: from the control by way of cutter compensation to machine coordinates.
#pragma once

#include "arcs.h"
#include "compensation.h"
#include "control.h"
#include "machine_motions.h"

namespace fieldfab::cam::gcode {

/// Makes motions with the control's modal state, advances its position, and passes them through the stages.
class MotionStream {
 public:
  MotionStream(Control& control, MotionSink sink);
  // The stages refer to each other.
  MotionStream(const MotionStream&) = delete;
  MotionStream& operator=(const MotionStream&) = delete;

  /// Position of the tool in program coordinates: with cutter compensation, beside the programmed one.
  [[nodiscard]] const AxisValues& position() const { return compensation_.on() ? compensation_.centre() : control_.at; }
  /// End of the last motion that left the stages, in program coordinates.
  [[nodiscard]] const AxisValues& sent() const { return machine_.at(); }

  /// A motion with the modal state, at the tool's position.
  [[nodiscard]] Motion stamped(Motion::Kind kind) const;
  /// Moves to a programmed position: a rapid or a feed.
  void straight(Motion::Kind kind, const AxisValues& to);
  void arc(const AxisValues& to, const Circle& circle);
  /// Moves to the motion's end, with the feed and spindle speed that it has.
  void move(const Motion& motion);
  /// Feeds along a chord of a spline, without compensation.
  void chord(const AxisValues& to);
  void dwell(double seconds);
  /// A motion without movement: a tool change, a stop, the end.
  void say(Motion::Kind kind) { compensation_.give(stamped(kind)); }

  [[nodiscard]] int compensation_side() const { return compensation_.side(); }
  void start_compensation(int side, double radius) { compensation_.start(side, radius, control_.at); }
  /// Passes on what compensation holds back, and ends it.
  void stop_compensation() { compensation_.stop(); }
  /// Throws Refusal if compensation is on. `what` begins the message.
  void no_compensation(std::string_view what) const;

  /// Replaces the control's frame. The machine does not move: positions become those in the new frame.
  void change_frame(const Frame& next);

 private:
  Control& control_;
  MachineMotions machine_;
  Compensation compensation_;
};

}  // namespace fieldfab::cam::gcode
