// Blocks with motions.
#pragma once

#include <optional>

#include "cycles.h"
#include "motion_stream.h"
#include "splines.h"

namespace fieldfab::cam::gcode {

/// Carries out the motion of a block: straight moves, arcs, splines, canned cycles, threads, probing, home positions.
class MotionWords {
 public:
  MotionWords(Control& control, MotionStream& stream, LineCount& count, Progress& progress)
      : control_(control), stream_(stream), count_(count), cycles_(control, stream, count, progress) {}

  /// Carries out a block's motion, if it has one, by its motion code or the one in force. Throws Refusal.
  void carry_out(const Block& block);
  /// G28 and G30: by way of the point given by the words to the point stored from parameter `first` on. Only the axes
  /// with words move; without words, all.
  void go_home(const Block& block, int first);

 private:
  void carry_out(const Block& block, int code);
  void straight(const Block& block, int code);
  [[nodiscard]] AxisValues machine_target(const Block& block) const;
  void arc(const Block& block, int code);
  void spindle_synchronous(const Block& block, int code);
  void probe(const Block& block);
  void spline(const Block& block, int code);
  void nurbs_point(const Block& block);
  void nurbs_end();
  void thread(const Block& block);
  void feed_along(const Vec2& place);

  Control& control_;
  MotionStream& stream_;
  LineCount& count_;
  Cycles cycles_;
  std::optional<Nurbs> nurbs_;        // from G5.2 to G5.3
  std::optional<Vec2> last_control_;  // G5: last control point of the previous cubic
};

}  // namespace fieldfab::cam::gcode
