#include "offsets.h"

namespace fieldfab::cam::gcode {

/// Replaces the first `count` coordinates that have a word.
void Offsets::replace_words(const Block& block, AxisValues& values, std::size_t count) const {
  for (std::size_t k = 0; k < count; ++k)
    if (const char letter = axis_letters[k]; block.has(letter)) values.at[k] = control_.word(block, letter);
}

/// Reads the origin and rotation of the coordinate system whose parameters begin at `first`.
void Offsets::load_system(Frame& frame, int first) const {
  for (int k = 0; k < 9; ++k) frame.origin.at[static_cast<std::size_t>(k)] = control_.parameters.stored(first + k);
  frame.rotation = control_.parameters.stored(first + 9);
}

void Offsets::select_system(int system) {
  // the system in force keeps its values, even if its parameters have changed
  if (system == control_.modes.system) return;
  stream_.no_compensation("another coordinate system");
  if (control_.frame.turned) refuse("another coordinate system while G68 is in force");
  control_.modes.system = system;
  control_.parameters.stored(number::coordinate_system) = system;
  stream_.change_frame(control_.stored_frame());
}

void Offsets::restore(const Modes& saved) {
  if (stream_.compensation_side() != 0) refuse("modes cannot be restored while cutter compensation is on");
  const int motion = control_.modes.motion;
  control_.modes = saved;
  control_.modes.motion = motion;
  control_.parameters.stored(number::coordinate_system) = saved.system;
  control_.parameters.stored(number::offset_active) = saved.axis_offset ? 1 : 0;
  Frame frame = control_.stored_frame();
  frame.tool = saved.tool_offset;
  stream_.change_frame(frame);
}

void Offsets::set_length_compensation(const Block& block) {
  const int code = block.code(GGroup::length);
  Frame frame = control_.frame;
  AxisValues offset = code == 432 ? frame.tool : AxisValues{};
  if (code == 430 || code == 432 || code == 434) {
    const int tool = block.has('h') ? whole(block['h']) : control_.tool;
    if (tool < 0) refuse("H{} is below 0", tool);
    if (code == 432 && !block.has('h')) refuse("G43.2 needs H");
    const Vec3 length = control_.tool_entry(tool == 0 ? control_.tool : tool).offset;  // 0: the tool in the spindle
    for (std::size_t k = 0; k < 3; ++k) offset.at[k] += length[static_cast<Eigen::Index>(k)];
  } else if (code == 431) {
    offset = frame.tool;
    if (block.has_any("abcuvw")) refuse("G43.1 is known for X, Y and Z only");
    if (!block.has_any("xyz")) refuse("G43.1 needs an axis word");
    replace_words(block, offset, 3);
  }
  stream_.no_compensation("a change of the tool's length");
  frame.tool = control_.modes.tool_offset = offset;
  stream_.change_frame(frame);
  if (code == 434) {
    control_.mode = ControlMode::tip;
    control_.tip_by_length = true;
  } else if (code == 490 && control_.tip_by_length) {
    control_.mode = ControlMode::axes;
    control_.tip_by_length = false;
  }
}

void Offsets::set_data(const Block& block) {
  if (!block.has('l')) refuse("G10 needs L");
  const int what = whole(block['l']);
  if (what == 0) return;  // reloads the tool table, which cannot have changed
  if (what != 1 && what != 2 && what != 10 && what != 11 && what != 20) refuse("G10 L{} is not known here", what);
  if (!block.has('p')) refuse("G10 needs P");
  const int number = whole(block['p']);
  stream_.no_compensation("G10");
  if (what == 2 || what == 20) return set_system(block, what, number);
  if (number < 1) refuse("G10 L{} P{}: there is no such tool", what, number);
  set_tool(block, what, control_.tools[number]);
}

/// G10 L2 and L20. For L20 the new system is the one in which the axes, at their position, have the given coordinates.
void Offsets::set_system(const Block& block, int what, int number) {
  if (number < 0 || number > 9) refuse("G10 L{} P{}: there are P1 to P9, and P0 for the one in force", what, number);
  if (what == 20 && block.has('r')) refuse("G10 L20 has no use for R");
  const int in_force = control_.modes.system, system = number == 0 ? in_force : number;
  const int first = number::system_start(system);
  if (control_.frame.turned) refuse("G10 L{} while G68 is in force", what);
  Frame frame = control_.frame;
  load_system(frame, first);
  if (block.has('r')) frame.rotation = block['r'];
  if (what == 2) {
    replace_words(block, frame.origin, 9);
  } else {
    const AxisValues axes = control_.frame.axes(control_.at);
    AxisValues place = frame.of_axes(axes);
    replace_words(block, place, 9);
    const AxisValues there = frame.axes(place);
    for (std::size_t k = 0; k < 9; ++k) frame.origin.at[k] += axes.at[k] - there.at[k];
  }
  for (int k = 0; k < 9; ++k) control_.parameters.stored(first + k) = frame.origin.at[static_cast<std::size_t>(k)];
  control_.parameters.stored(first + 9) = frame.rotation;
  if (system == in_force) stream_.change_frame(control_.stored_frame());
}

/// G10 L1: the words are the tool's offset. L10 and L11: with that offset the axes, at their position, have the given
/// coordinates, in the system in force or in G59.3 without G92.
void Offsets::set_tool(const Block& block, int what, ToolEntry& tool) {
  AxisValues offset;
  for (std::size_t k = 0; k < 3; ++k) offset.at[k] = tool.offset[static_cast<Eigen::Index>(k)];
  if (what == 1) {
    replace_words(block, offset, 3);
  } else {
    Frame frame = control_.frame;
    if (what == 11) {
      frame.axis_offset = {};
      load_system(frame, number::system_start(9));
    }
    frame.tool = offset;
    const AxisValues axes = control_.frame.axes(control_.at);
    AxisValues place = frame.of_axes(axes);
    replace_words(block, place, 3);
    offset = Frame::added(axes, frame.tip(place), -1);
  }
  tool.offset = offset.xyz();
  if (block.has('r')) tool.diameter = 2 * control_.modes.length(block['r']);
}

void Offsets::keep_home(int first) {
  const AxisValues axes = control_.frame.axes(stream_.position());
  for (int k = 0; k < 9; ++k) control_.parameters.stored(first + k) = axes.at[static_cast<std::size_t>(k)];
}

void Offsets::set_axis_offset(const Block& block) {
  const int code = block.code(GGroup::action);
  stream_.no_compensation(g_name(code));
  if (control_.frame.turned) refuse("{} while G68 is in force", g_name(code));
  if ((code == 920 || code == 520) && !block.has_any(axis_letters)) refuse("{} needs axis words", g_name(code));
  Parameters& parameters = control_.parameters;
  Frame frame = control_.frame;
  AxisValues& offset = frame.axis_offset;
  if (code == 920) {
    for (std::size_t k = 0; k < 9; ++k)
      if (const char letter = axis_letters[k]; block.has(letter))
        offset.at[k] += control_.at.at[k] - control_.word(block, letter);
  } else if (code == 520) {
    replace_words(block, offset, 9);
  } else if (code == 923) {
    for (int k = 0; k < 9; ++k) offset.at[static_cast<std::size_t>(k)] = parameters.stored(number::axis_offset + k);
  } else {
    offset = {};
  }
  parameters.stored(number::offset_active) = code == 921 || code == 922 ? 0 : 1;
  if (code != 922)  // which leaves them for G92.3
    for (int k = 0; k < 9; ++k) parameters.stored(number::axis_offset + k) = offset.at[static_cast<std::size_t>(k)];
  stream_.change_frame(frame);
}

void Offsets::turn_program(const Block& block) {
  stream_.no_compensation("G68 and G69");
  Frame frame = control_.frame;
  frame.turned.reset();
  if (block.code(GGroup::rotation) == 690) return stream_.change_frame(frame);
  if (!block.has('r')) refuse("G68 needs R, the angle");
  const PlaneAxes axes = axes_of(control_.modes.plane);
  for (std::size_t k = 0; k < 9; ++k)
    if (block.has(axis_letters[k]) && k != axes.first && k != axes.second)
      refuse("G68 turns about a point of the plane in force");
  AxisValues centre = frame.of_axes(control_.frame.axes(control_.at));
  for (const std::size_t k : {axes.first, axes.second})
    if (const char letter = axis_letters[k]; block.has(letter)) centre.at[k] = control_.word(block, letter);
  frame.turned = Turned{control_.modes.plane, in_plane(centre, axes), block['r']};
  stream_.change_frame(frame);
}

}  // namespace fieldfab::cam::gcode
