// Blocks with canned cycles.
#pragma once

#include "holes.h"
#include "motion_stream.h"
#include "sources.h"

namespace fieldfab::cam::gcode {

/// Carries out blocks with canned cycles, in all three planes. Words stay in force from block to block.
class Cycles {
 public:
  Cycles(Control& control, MotionStream& stream, LineCount& count, Progress& progress)
      : control_(control), stream_(stream), count_(count), progress_(progress) {}

  /// Whether a motion code (times ten) is a canned cycle.
  [[nodiscard]] static bool is_cycle(int code) { return code >= 730 && code <= 890 && code != 760 && code != 800; }
  void carry_out(const Block& block, int code);

 private:
  void take_words(const Block& block, int code);
  [[nodiscard]] Hole first_hole(const Block& block, int code) const;
  void repeat(const Block& block, Hole hole, int repeats);
  void make(const Hole& hole);

  Control& control_;
  MotionStream& stream_;
  LineCount& count_;
  Progress& progress_;
  // Words in force, in the program's units.
  double r_ = 0, z_ = 0, p_ = 0, q_ = 0, i_ = 0, j_ = 0, k_ = 0;
  double start_ = 0;  // height before the first of consecutive cycles, mm
};

}  // namespace fieldfab::cam::gcode
