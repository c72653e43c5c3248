// State of the control: modes, coordinate systems, parameters, tools and the programmed position.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "block.h"
#include "frame.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {

constexpr std::string_view axis_letters = "xyzabcuvw";

/// Modal state, which M70 saves.
struct Modes {
  int motion = 800;  ///< G code times ten; 800: none
  ArcPlane plane = ArcPlane::xy;
  bool absolute = true, arcs_absolute = false, inch = false, diameter = false;
  bool retract_to_start = false;  ///< G98; LinuxCNC's default is G99
  int feed_mode = 940;
  int system = 1;  ///< coordinate system: 1 is G54
  int path = 640;
  double feed = 0;       ///< the F word: units of length (or degrees) per minute, per revolution, or 1/minutes
  double feed_unit = 1;  ///< mm per unit of length at the time of F
  double speed = 0;      ///< the S word: revolutions per minute, or m/min under G96
  int spindle = 0;       ///< 1 clockwise, -1 anticlockwise
  bool constant_surface = false;
  double most_speed = 0;  ///< G96 D
  bool mist = false, flood = false, feed_override = true, speed_override = true;
  AxisValues tool_offset;
  bool axis_offset = false;  ///< whether G92 or G52 was in force at M70

  /// Unit of length of the program, mm.
  [[nodiscard]] double unit() const { return inch ? 25.4 : 1; }
  /// A length of the program, mm.
  [[nodiscard]] double length(double value) const { return value * unit(); }
  /// Speed of the spindle with the tool at a position, revolutions per minute; negative: anticlockwise.
  [[nodiscard]] double spindle_at(const AxisValues& place) const;
  /// Sets the feed of a motion from a position. Under G93 sets `seconds` to -1: MachineMotions computes it.
  void set_feed(Motion& canonical, const AxisValues& from) const;
};

/// State of the control. Positions are in program coordinates: mm, degrees.
struct Control {
  Control(const ReadingOptions& options, const PredefinedParameters& predefined);

  Dialect dialect;
  std::map<int, ToolEntry> tools;
  Parameters parameters;
  Modes modes;
  Frame frame;
  AxisValues at;  ///< programmed position; with cutter compensation, the tool is beside it
  int tool = 0, selected_tool = 0;
  ControlMode mode = ControlMode::machine;
  bool tip_by_length = false;  ///< whether G43.4 is in force
  int line = 0;                ///< line in execution
  Notes notes;

  void note(std::string message) { notes.add(line, std::move(message)); }
  /// Entry of the tool table. Throws Refusal for a tool without one.
  [[nodiscard]] const ToolEntry& tool_entry(int number) const;
  /// The frame with the coordinate system in force and G92 as the parameters say.
  [[nodiscard]] Frame stored_frame() const;
  /// A word's value in the unit of its axis: mm or degrees.
  [[nodiscard]] double word(const Block& block, char letter) const;
  /// The position that a block's words give.
  [[nodiscard]] AxisValues target(const Block& block) const;
  /// Checks that a feed can be made. Throws Refusal.
  void require_feed(const Block& block);
};

}  // namespace fieldfab::cam::gcode
