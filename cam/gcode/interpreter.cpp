#include "interpreter.h"

#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {

std::vector<ReadingNote> read_gcode(std::string_view text, const std::string& file, const ReadingOptions& options,
                                    const MotionSink& sink, Progress& progress) {
  return gcode::Interpreter(text, file, options, sink, progress).run();
}

namespace gcode {

Interpreter::Interpreter(std::string_view text, const std::string& file, const ReadingOptions& options,
                         const MotionSink& sink, Progress& progress)
    : progress_(progress),
      predefined_(control_, stream_, flow_),
      control_(options, predefined_),
      stream_(control_, sink),
      count_(options.most_blocks),
      flow_(text, file, options.folders, count_, control_.parameters),
      decoder_(control_.parameters, options.dialect, options.block_delete,
               [this](std::string what) { control_.note(std::move(what)); }),
      offsets_(control_, stream_),
      motions_(control_, stream_, count_, progress) {
  flow_.on_return([this] { restore_on_return(); });
}

std::vector<ReadingNote> Interpreter::run() {
  const auto place = [this] { return fmt::format("{}:{}", flow_.file(), flow_.line()); };
  try {
    while (!finished_ && step()) {
      if (count_.lines() % 1024 == 0) {
        progress_.check();
        if (count_.lines() % 65536 == 0) progress_.report(flow_.share(), "reading the program");
      }
    }
    if (!finished_) {
      stream_.stop_compensation();
      control_.notes.add(flow_.line(), delimited_ ? "the program ends without M2, M30 or a second %"
                                                  : "the program ends without M2 or M30");
    }
  } catch (const Refusal& refusal) {
    throw Error(ErrorKind::bad_input, place(), refusal.message);
  }
  return control_.notes.take();
}

bool Interpreter::step() {
  if (!flow_.next(line_)) return false;
  control_.line = flow_.line();
  decoder_.decode(line_, control_.modes.motion, command_);
  switch (command_.kind) {
    case Command::Kind::nothing: return true;
    case Command::Kind::delimiter:
      if (!flow_.in_program()) return true;
      if (begun_) end_program();
      begun_ = delimited_ = true;
      return true;
    case Command::Kind::flow:
      begun_ = true;
      flow_.carry_out(line_);
      return true;
    case Command::Kind::block:
      begun_ = true;
      execute();
      return true;
  }
  return true;
}

void Interpreter::execute() {
  const ModalWords& set = command_.modal;
  Modes& modes = control_.modes;
  if (set.feed_mode) {
    if (*set.feed_mode != modes.feed_mode) modes.feed = 0;  // the number has another meaning in the new mode
    modes.feed_mode = *set.feed_mode;
  }
  if (block_.has('f')) set_feed();
  set_speed();
  if (block_.has('t')) select_tool();
  machine_words();
  if (block_.code(GGroup::action) == 40) dwell();
  if (set.plane) set_plane(*set.plane);
  if (set.inch) modes.inch = *set.inch;
  if (set.diameter) modes.diameter = *set.diameter;
  if (block_.code(GGroup::compensation) != Block::none) set_compensation();
  if (block_.code(GGroup::length) != Block::none) offsets_.set_length_compensation(block_);
  if (set.system) offsets_.select_system(*set.system);
  if (set.path) modes.path = *set.path;
  if (set.absolute) modes.absolute = *set.absolute;
  if (set.arcs_absolute) modes.arcs_absolute = *set.arcs_absolute;
  if (set.retract_to_start) modes.retract_to_start = *set.retract_to_start;
  if (block_.code(GGroup::rotation) != Block::none) offsets_.turn_program(block_);
  action();
  motions_.carry_out(block_);
  stop_words();
}

void Interpreter::set_feed() {
  Modes& modes = control_.modes;
  const double feed = block_['f'];
  if (feed < 0) refuse("F{} is below 0", feed);
  modes.feed = feed;
  modes.feed_unit = modes.unit();  // F precedes G20 and G21 in a block's order of execution
  if (const int units = block_.code(GGroup::units);
      units != Block::none && (units == 200) != modes.inch && modes.feed_mode != 930)
    control_.note(fmt::format("F in the block of {} still counts in the units before it", g_name(units)));
}

void Interpreter::set_speed() {
  Modes& modes = control_.modes;
  if (block_.has('s') && !(block_.code(GGroup::action) == 40 && !block_.has('p'))) {
    const double speed = block_['s'];
    if (speed < 0) refuse("S{} is below 0", speed);
    modes.speed = speed;
  }
  const int code = block_.code(GGroup::spindle_mode);
  if (code == Block::none) return;
  if (!block_.has('s') && code == 960) refuse("{} needs S", g_name(code));
  modes.constant_surface = code == 960;
  modes.most_speed = 0;
  if (code == 960 && block_.has('d')) {
    modes.most_speed = block_['d'];
    if (modes.most_speed <= 0) refuse("G96 with D{}: the greatest speed must be above 0", modes.most_speed);
  }
}

void Interpreter::select_tool() {
  const int tool = whole(block_['t']);
  if (tool < 0) refuse("T{} is below 0", tool);
  if (tool != 0 && !control_.tools.contains(tool)) control_.note(fmt::format("tool {} is not in the tool table", tool));
  control_.selected_tool = tool;
  // Behind GRBL a person changes tools: the one that a program names is in the spindle, with M6 or without.
  if (control_.dialect != Dialect::grbl || tool == control_.tool || block_.code(MGroup::tool) == 6) return;
  control_.tool = tool;
  stream_.say(Motion::Kind::tool_change);
}

void Interpreter::machine_words() {
  const ModalWords& set = command_.modal;
  Modes& modes = control_.modes;
  const int tool = block_.code(MGroup::tool);
  if (tool == 6) change_tool();
  if (tool == 61) take_tool();
  if (set.spindle) modes.spindle = *set.spindle;
  if (const int code = block_.code(MGroup::coolant); code != Block::none) {
    modes.mist = code == 7 || (code == 8 && modes.mist);
    modes.flood = code == 8 || (code == 7 && modes.flood);
  }
  if (const int code = block_.code(MGroup::override_); code == 48 || code == 49)
    modes.feed_override = modes.speed_override = code == 48;
  if (const int code = block_.code(MGroup::in_out); code != Block::none)
    control_.note(code == 66 ? "M66 waits for an input: it is taken as not there (#5399 is -1)"
                             : fmt::format("M{} sets an output: passed over", code));
  state_words();
  if (set.control) set_control(*set.control);
  if (const int code = block_.code(MGroup::user); code != Block::none)
    control_.note(fmt::format("M{} has no meaning here: passed over", code));
}

void Interpreter::change_tool() {
  stream_.no_compensation("M6");
  control_.tool = control_.selected_tool;
  control_.modes.spindle = 0;
  control_.at = stream_.sent();  // the actual position, not the programmed end of a compensated path
  stream_.say(Motion::Kind::tool_change);
}

/// M61: the tool in the spindle gets another number.
void Interpreter::take_tool() {
  if (!block_.has('q')) refuse("M61 needs Q, the tool's number");
  const int number = whole(block_['q']);
  if (number < 0) refuse("M61 with Q{}, which is below 0", number);
  control_.tool = number;
  stream_.say(Motion::Kind::tool_change);
}

void Interpreter::set_control(ControlMode mode) {
  stream_.no_compensation("a change of kinematics");
  control_.mode = mode;
  control_.tip_by_length = false;
}

/// G4. G4 S3 in programs for Marlin means three seconds. In other dialects S in such a block sets the spindle.
void Interpreter::dwell() {
  if (!block_.has('p') && block_.has('s'))
    control_.note("G4 with S and no P is taken as seconds, as Marlin does");
  else if (!block_.has('p'))
    refuse("G4 needs P, the seconds");
  stream_.dwell(block_.has('p') ? block_['p'] : block_['s']);
}

void Interpreter::set_plane(ArcPlane plane) {
  if (plane != control_.modes.plane) stream_.no_compensation("a change of plane");
  control_.modes.plane = plane;
}

void Interpreter::set_compensation() {
  const int code = block_.code(GGroup::compensation);
  if (code == 400) return stream_.stop_compensation();
  const ArcPlane plane = control_.modes.plane;
  if (plane == ArcPlane::yz) refuse("cutter compensation is of the planes G17 and G18");
  stream_.no_compensation(g_name(code));
  if (plane == ArcPlane::zx && control_.frame.rotation != 0)
    refuse("cutter compensation in G18 with a rotated coordinate system");
  double radius = 0;
  if (code == 411 || code == 421) {
    if (!block_.has('d')) refuse("{} needs D, the tool's diameter", g_name(code));
    radius = control_.modes.length(block_['d']) / 2;
  } else {
    const int tool = block_.has('d') ? whole(block_['d']) : control_.tool;
    if (tool < 0) refuse("D{} is below 0", tool);
    radius = control_.tool_entry(tool == 0 ? control_.tool : tool).diameter / 2;
  }
  stream_.start_compensation((code < 420 ? 1 : -1) * (radius < 0 ? -1 : 1), std::abs(radius));
}

void Interpreter::action() {
  switch (block_.code(GGroup::action)) {
    case 100: offsets_.set_data(block_); break;
    case 280: motions_.go_home(block_, number::first_home); break;
    case 300: motions_.go_home(block_, number::second_home); break;
    case 281: offsets_.keep_home(number::first_home); break;
    case 301: offsets_.keep_home(number::second_home); break;
    case 520:
    case 920:
    case 921:
    case 922:
    case 923: offsets_.set_axis_offset(block_); break;
    default: break;
  }
}

/// M70 to M73.
void Interpreter::state_words() {
  switch (block_.code(MGroup::state)) {
    case 70: save_state(false); break;
    case 71: saved_.reset(); break;
    case 72:
      if (!saved_) refuse("M72 where M70 has saved nothing");
      offsets_.restore(*saved_);
      break;
    case 73: save_state(true); break;
    default: break;
  }
}

void Interpreter::save_state(bool restore_on_return) {
  Modes& modes = control_.modes;
  modes.axis_offset = control_.parameters.stored(number::offset_active) != 0;
  if (!restore_on_return) {
    saved_ = modes;
  } else if (flow_.in_program()) {
    control_.note("M73 outside of a subroutine does nothing");
  } else if (saved_in_calls_.empty() || saved_in_calls_.back().depth != flow_.depth()) {
    saved_in_calls_.push_back({flow_.depth(), modes});
  }
}

void Interpreter::restore_on_return() {
  while (!saved_in_calls_.empty() && saved_in_calls_.back().depth > flow_.depth()) {
    const Modes saved = saved_in_calls_.back().modes;
    saved_in_calls_.pop_back();
    offsets_.restore(saved);
  }
}

void Interpreter::stop_words() {
  const int code = block_.code(MGroup::stop);
  if (code == 0 || code == 1 || code == 60) {
    stream_.say(Motion::Kind::stop);
  } else if (code == 2 || code == 30) {
    end_program();
  } else if (code == 98) {
    if (!block_.has('p')) refuse("M98 needs P, the program's number");
    const int repeats = block_.has('l') ? whole(block_['l']) : 1;
    if (repeats < 0) refuse("M98 with L{}, which is below 0", repeats);
    flow_.call_program(whole(block_['p']), repeats);
  } else if (code == 99) {
    if (!flow_.return_program()) {
      control_.note("M99 in the main program would begin it anew for ever: it ends here");
      end_program();
    }
  }
}

void Interpreter::end_program() {
  stream_.say(Motion::Kind::end);
  stream_.stop_compensation();
  finished_ = true;
}

}  // namespace gcode
}  // namespace fieldfab::cam
