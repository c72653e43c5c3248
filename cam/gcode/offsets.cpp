// Coordinate systems, G92, tool lengths, home positions, G68. A change of them moves the program's
// coordinates, never the machine.
#include <cmath>

#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr std::string_view letters = "xyzabcuvw";

}  // namespace

void Interpreter::no_compensation(const char* what) const {
  if (compensation_.side != 0) refuse("{} cannot be used while cutter compensation is on", what);
}

void Interpreter::change_frame(const std::function<void()>& change) {
  const AxisValues axes = frame_.axes(at_), sent = frame_.axes(sent_);
  change();
  at_ = frame_.of_axes(axes);
  sent_ = frame_.of_axes(sent);
}

/// Reads the frame's parts from the parameters.
void Interpreter::read_system() {
  const int first = number::system_start(modes_.system);
  for (int k = 0; k < 9; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    frame_.origin.at[axis] = parameters_.stored(first + k);
    frame_.axis_offset.at[axis] =
        parameters_.stored(number::offset_active) != 0 ? parameters_.stored(number::axis_offset + k) : 0;
  }
  frame_.rotation = parameters_.stored(first + 9);
}

void Interpreter::set_system(int system) {
  if (system != modes_.system) no_compensation("another coordinate system");
  if (system == modes_.system && compensation_.side != 0) return;
  if (frame_.turned && system != modes_.system) refuse("another coordinate system while G68 is in force");
  // the system in force keeps its values, even if its parameters have changed
  if (system == modes_.system) return;
  change_frame([&] {
    modes_.system = system;
    parameters_.stored(number::coordinate_system) = system;
    read_system();
  });
}

void Interpreter::set_length_compensation() {
  const int code = block_.code(GGroup::length);
  AxisValues offset = code == 432 ? frame_.tool : AxisValues{};
  if (code == 430 || code == 432 || code == 434) {
    const int tool = block_.has('h') ? whole(block_['h']) : tool_;
    if (tool < 0) refuse("H{} is below 0", tool);
    if (code == 432 && !block_.has('h')) refuse("G43.2 needs H");
    const Vec3 length = tool_entry(tool == 0 ? tool_ : tool).offset;  // 0 means the tool in the spindle
    for (std::size_t k = 0; k < 3; ++k) offset.at[k] += length[static_cast<Eigen::Index>(k)];
  } else if (code == 431) {
    offset = frame_.tool;
    if (block_.has_any("abcuvw")) refuse("G43.1 is known for X, Y and Z only");
    if (!block_.has_any("xyz")) refuse("G43.1 needs an axis word");
    for (std::size_t k = 0; k < 3; ++k)
      if (block_.has(letters[k])) offset.at[k] = word(letters[k]);
  }
  no_compensation("a change of the tool's length");
  change_frame([&] { frame_.tool = modes_.tool_offset = offset; });
  if (code == 434) {
    mode_ = ControlMode::tip;
    tip_by_length_ = true;
  } else if (code == 490 && tip_by_length_) {
    mode_ = ControlMode::axes;
    tip_by_length_ = false;
  }
}

void Interpreter::action() {
  switch (block_.code(GGroup::action)) {
    case 100: set_data(); break;
    case 280: go_home(number::first_home); break;
    case 300: go_home(number::second_home); break;
    case 281: keep_home(number::first_home); break;
    case 301: keep_home(number::second_home); break;
    case 520:
    case 920:
    case 921:
    case 922:
    case 923: set_axis_offset(); break;
    default: break;
  }
}

/// G10: L2 and L20 set coordinate systems; L1, L10 and L11 set the tool table.
void Interpreter::set_data() {
  if (!block_.has('l')) refuse("G10 needs L");
  const int what = whole(block_['l']);
  if (what == 0) return;  // reloads the tool table, which cannot have changed
  if (what != 1 && what != 2 && what != 10 && what != 11 && what != 20) refuse("G10 L{} is not known here", what);
  if (!block_.has('p')) refuse("G10 needs P");
  const int number = whole(block_['p']);
  no_compensation("G10");
  if (what == 2 || what == 20) {
    if (number < 0 || number > 9) refuse("G10 L{} P{}: there are P1 to P9, and P0 for the one in force", what, number);
    if (what == 20 && block_.has('r')) refuse("G10 L20 has no use for R");
    const int system = number == 0 ? modes_.system : number, first = number::system_start(system);
    if (frame_.turned) refuse("G10 L{} while G68 is in force", what);
    // The new system. For L20 it is the one in which the axes, at their position, have the given
    // coordinates.
    Frame frame = frame_;
    for (int k = 0; k < 9; ++k) frame.origin.at[static_cast<std::size_t>(k)] = parameters_.stored(first + k);
    frame.rotation = block_.has('r') ? block_['r'] : parameters_.stored(first + 9);
    if (what == 2) {
      for (std::size_t k = 0; k < 9; ++k)
        if (block_.has(letters[k])) frame.origin.at[k] = word(letters[k]);
    } else {
      const AxisValues axes = frame_.axes(at_);
      AxisValues place = frame.of_axes(axes);
      for (std::size_t k = 0; k < 9; ++k)
        if (block_.has(letters[k])) place.at[k] = word(letters[k]);
      const AxisValues there = frame.axes(place);
      for (std::size_t k = 0; k < 9; ++k) frame.origin.at[k] += axes.at[k] - there.at[k];
    }
    for (int k = 0; k < 9; ++k) parameters_.stored(first + k) = frame.origin.at[static_cast<std::size_t>(k)];
    parameters_.stored(first + 9) = frame.rotation;
    if (system == modes_.system) change_frame([&] { read_system(); });
    return;
  }
  if (number < 1) refuse("G10 L{} P{}: there is no such tool", what, number);
  ToolEntry& tool = options_.tools[number];
  if (what == 1) {
    for (std::size_t k = 0; k < 3; ++k)
      if (block_.has(letters[k])) tool.offset[static_cast<Eigen::Index>(k)] = word(letters[k]);
  } else {
    Frame frame = frame_;
    if (what == 11) {
      const int first = number::system_start(9);
      frame.axis_offset = {};
      for (int k = 0; k < 9; ++k) frame.origin.at[static_cast<std::size_t>(k)] = parameters_.stored(first + k);
      frame.rotation = parameters_.stored(first + 9);
    }
    const AxisValues axes = frame_.axes(at_);
    frame.tool = {};
    for (std::size_t k = 0; k < 3; ++k) frame.tool.at[k] = tool.offset[static_cast<Eigen::Index>(k)];
    AxisValues place = frame.of_axes(axes);
    for (std::size_t k = 0; k < 3; ++k)
      if (block_.has(letters[k])) place.at[k] = word(letters[k]);
    const AxisValues tip = frame.tip(place);
    for (std::size_t k = 0; k < 3; ++k) tool.offset[static_cast<Eigen::Index>(k)] = axes.at[k] - tip.at[k];
  }
  if (block_.has('r')) tool.diameter = 2 * length(block_['r']);
}

/// G28 and G30: by way of the point given by the words to the stored point. Only the axes with
/// words move; without words, all.
void Interpreter::go_home(int first) {
  no_compensation("G28");
  if (frame_.turned) refuse("G28 and G30 cannot be used while G68 is in force");
  AxisValues home;
  for (int k = 0; k < 9; ++k) home.at[static_cast<std::size_t>(k)] = parameters_.stored(first + k);
  home = frame_.of_axes(home);
  AxisValues to = target();
  if (block_.has_any(letters)) {
    move(Motion::Kind::rapid, to);
    for (std::size_t k = 0; k < 9; ++k)
      if (!block_.has(letters[k])) home.at[k] = to.at[k];
  }
  move(Motion::Kind::rapid, home);
}

void Interpreter::keep_home(int first) {
  const AxisValues axes = frame_.axes(at_);
  for (int k = 0; k < 9; ++k) parameters_.stored(first + k) = axes.at[static_cast<std::size_t>(k)];
}

void Interpreter::set_axis_offset() {
  const int code = block_.code(GGroup::action);
  no_compensation(g_name(code).c_str());
  if (frame_.turned) refuse("{} while G68 is in force", g_name(code));
  const bool words = block_.has_any(letters);
  if ((code == 920 || code == 520) && !words) refuse("{} needs axis words", g_name(code));
  change_frame([&] {
    AxisValues offset = frame_.axis_offset;
    const auto keep = [&](bool active) {
      parameters_.stored(number::offset_active) = active ? 1 : 0;
      for (int k = 0; k < 9; ++k) parameters_.stored(number::axis_offset + k) = offset.at[static_cast<std::size_t>(k)];
    };
    switch (code) {
      case 920:
        for (std::size_t k = 0; k < 9; ++k)
          if (block_.has(letters[k])) offset.at[k] += at_.at[k] - word(letters[k]);
        keep(true);
        break;
      case 520:
        for (std::size_t k = 0; k < 9; ++k)
          if (block_.has(letters[k])) offset.at[k] = word(letters[k]);
        keep(true);
        break;
      case 921:
        offset = {};
        keep(false);
        break;
      case 922:
        offset = {};
        parameters_.stored(number::offset_active) = 0;
        break;
      default:
        parameters_.stored(number::offset_active) = 1;
        for (int k = 0; k < 9; ++k)
          offset.at[static_cast<std::size_t>(k)] = parameters_.stored(number::axis_offset + k);
        break;
    }
    frame_.axis_offset = offset;
  });
}

/// G68 and G69: rotation of the program about a point of the plane, as on Fanuc controls.
void Interpreter::turn_program() {
  no_compensation("G68 and G69");
  if (block_.code(GGroup::rotation) == 690) {
    change_frame([&] { frame_.turned.reset(); });
    return;
  }
  if (!block_.has('r')) refuse("G68 needs R, the angle");
  const PlaneAxes axes = axes_of(modes_.plane);
  for (std::size_t k = 0; k < 9; ++k)
    if (block_.has(letters[k]) && k != axes.first && k != axes.second)
      refuse("G68 turns about a point of the plane in force");
  const AxisValues stand = frame_.axes(at_);
  change_frame([&] {
    frame_.turned.reset();
    AxisValues centre = frame_.of_axes(stand);
    if (block_.has(letters[axes.first])) centre.at[axes.first] = word(letters[axes.first]);
    if (block_.has(letters[axes.second])) centre.at[axes.second] = word(letters[axes.second]);
    frame_.turned = Turned{modes_.plane, {centre.at[axes.first], centre.at[axes.second]}, block_['r']};
  });
}

}  // namespace fieldfab::cam::gcode
