// Conversion of motions to machine coordinates: the last stage before the reader's caller.
#pragma once

#include <utility>

#include "frame.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {

/// Converts motions from program coordinates (mm, degrees) to machine coordinates (mm, radians). Arcs that the frame
/// takes out of their plane become chords. Computes the duration of feeds under G93, whose `seconds` is -1.
class MachineMotions {
 public:
  /// `frame` is the control's, at all times. `start`: position in the program.
  MachineMotions(const Frame& frame, const AxisValues& start, Notes& notes, MotionSink next)
      : frame_(frame), notes_(notes), next_(std::move(next)), at_(start) {}

  /// Throws Refusal for a position that no machine can reach.
  void give(Motion motion);
  /// End of the last motion, in program coordinates.
  [[nodiscard]] const AxisValues& at() const { return at_; }
  /// Converts that position to a frame that is about to replace the control's. The machine does not move.
  void change_frame(const Frame& next) { at_ = next.of_axes(frame_.axes(at_)); }

 private:
  void give_chords(const Motion& arc);

  const Frame& frame_;
  Notes& notes_;
  MotionSink next_;
  AxisValues at_;
};

}  // namespace fieldfab::cam::gcode
