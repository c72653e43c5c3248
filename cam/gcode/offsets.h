// Blocks that set coordinate systems, G92, tool lengths, home positions and G68.
#pragma once

#include "motion_stream.h"

namespace fieldfab::cam::gcode {

/// Carries out the words that change where the program's coordinates are. They never move the machine. All throw
/// Refusal while cutter compensation is on, except for words without effect.
class Offsets {
 public:
  Offsets(Control& control, MotionStream& stream) : control_(control), stream_(stream) {}

  /// G54 to G59.3: `system` is 1 to 9.
  void select_system(int system);
  /// G43 to G43.2, G43.4 and G49.
  void set_length_compensation(const Block& block);
  /// G10: L2 and L20 set coordinate systems; L1, L10 and L11 set the tool table.
  void set_data(const Block& block);
  /// G28.1 and G30.1: stores the position of the axes from parameter `first` on.
  void keep_home(int first);
  /// G92 to G92.3 and G52.
  void set_axis_offset(const Block& block);
  /// G68 and G69: rotation of the program about a point of the plane, as on Fanuc controls.
  void turn_program(const Block& block);
  /// Returns to saved modes (M72), except for the motion mode.
  void restore(const Modes& saved);

 private:
  void set_system(const Block& block, int what, int number);
  void set_tool(const Block& block, int what, ToolEntry& tool);
  void replace_words(const Block& block, AxisValues& values, std::size_t count) const;
  void load_system(Frame& frame, int first) const;

  Control& control_;
  MotionStream& stream_;
};

}  // namespace fieldfab::cam::gcode
