#include "interpreter.h"

#include <cmath>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

std::vector<ReadingNote> read_gcode(std::string_view text, const std::string& file, const ReadingOptions& options,
                                    const MotionSink& sink, Progress& progress) {
  return gcode::Interpreter(text, file, options, sink, progress).run();
}

namespace gcode {
namespace {

/// Conversion of angles: radians in the interface, degrees in programs.
AxisValues in_degrees(AxisValues values) {
  for (std::size_t k = 3; k < 6; ++k) values.at[k] *= degrees_per_radian;
  return values;
}

}  // namespace

Interpreter::Interpreter(std::string_view text, const std::string& file, const ReadingOptions& options,
                         const MotionSink& sink, Progress& progress)
    : options_(options),
      sink_(sink),
      progress_(progress),
      parameters_(*this),
      flow_(text, file, options.folders, options.most_blocks, parameters_),
      decoder_(parameters_, options.dialect, options.block_delete,
               [this](std::string what) { notes_.add(flow_.line(), std::move(what)); }) {
  modes_.inch = options.inch;
  if (options.dialect != Dialect::linuxcnc) modes_.motion = 0, modes_.retract_to_start = true;
  const auto store = [&](int first, const AxisValues& values) {
    for (int k = 0; k < 9; ++k) parameters_.stored(first + k) = in_degrees(values).at[static_cast<std::size_t>(k)];
  };
  store(number::first_home, options.home[0]);
  store(number::second_home, options.home[1]);
  for (int k = 0; k < 9; ++k) store(number::system_start(k + 1), options.work_offsets[static_cast<std::size_t>(k)]);
  parameters_.stored(number::coordinate_system) = 1;
  parameters_.stored(number::input_value) = -1;
  read_system();
  at_ = sent_ = frame_.of_axes(in_degrees(options.start));
  flow_.on_return([this] {
    while (!saved_in_calls_.empty() && saved_in_calls_.back().depth > flow_.depth()) {
      const Modes saved = saved_in_calls_.back().modes;
      saved_in_calls_.pop_back();
      restore_state(saved);
    }
  });
}

std::vector<ReadingNote> Interpreter::run() {
  const auto place = [this] { return fmt::format("{}:{}", flow_.file(), flow_.line()); };
  try {
    while (!finished_ && step()) {
      if (flow_.lines() % 1024 == 0) {
        progress_.check();
        if (flow_.lines() % 65536 == 0) progress_.report(flow_.share(), "reading the program");
      }
    }
    if (!finished_) {
      flush();
      notes_.add(flow_.line(),
                 delimited_ ? "the program ends without M2, M30 or a second %" : "the program ends without M2 or M30");
    }
  } catch (const Refusal& refusal) {
    throw Error(ErrorKind::bad_input, place(), refusal.message);
  }
  return notes_.take();
}

bool Interpreter::step() {
  if (!flow_.next(line_)) return false;
  decoder_.decode(line_, modes_.motion, command_);
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
  if (set.feed_mode) set_feed_mode(*set.feed_mode);
  if (block_.has('f')) set_feed();
  set_speed();
  if (block_.has('t')) select_tool();
  do_modal_m();
  if (block_.code(GGroup::action) == 40) {
    // G4 S3 in programs for Marlin means three seconds. In other dialects S in such a block sets
    // the spindle.
    if (!block_.has('p') && block_.has('s'))
      notes_.add(flow_.line(), "G4 with S and no P is taken as seconds, as Marlin does");
    else if (!block_.has('p'))
      refuse("G4 needs P, the seconds");
    dwell(block_.has('p') ? block_['p'] : block_['s']);
  }
  if (set.plane) set_plane(*set.plane);
  if (set.inch) modes_.inch = *set.inch;
  if (set.diameter) modes_.diameter = *set.diameter;
  if (block_.code(GGroup::compensation) != Block::none) set_compensation();
  if (block_.code(GGroup::length) != Block::none) set_length_compensation();
  if (set.system) set_system(*set.system);
  if (set.path) modes_.path = *set.path;
  if (set.absolute) modes_.absolute = *set.absolute;
  if (set.arcs_absolute) modes_.arcs_absolute = *set.arcs_absolute;
  if (set.retract_to_start) modes_.retract_to_start = *set.retract_to_start;
  if (block_.code(GGroup::rotation) != Block::none) turn_program();
  action();
  motion();
  do_stop();
}

void Interpreter::set_feed_mode(int code) {
  if (code != modes_.feed_mode) modes_.feed = 0;  // the number has another meaning in the new mode
  modes_.feed_mode = code;
}

void Interpreter::set_feed() {
  const double feed = block_['f'];
  if (feed < 0) refuse("F{} is below 0", feed);
  modes_.feed = feed;
  modes_.feed_unit = unit();  // F precedes G20 and G21 in a block's order of execution
  if (const int units = block_.code(GGroup::units);
      units != Block::none && (units == 200) != modes_.inch && modes_.feed_mode != 930)
    notes_.add(flow_.line(), fmt::format("F in the block of {} still counts in the units before it", g_name(units)));
}

void Interpreter::set_speed() {
  if (block_.has('s') && !(block_.code(GGroup::action) == 40 && !block_.has('p'))) {
    const double speed = block_['s'];
    if (speed < 0) refuse("S{} is below 0", speed);
    modes_.speed = speed;
  }
  const int code = block_.code(GGroup::spindle_mode);
  if (code == Block::none) return;
  if (!block_.has('s') && code == 960) refuse("{} needs S", g_name(code));
  modes_.constant_surface = code == 960;
  modes_.most_speed = 0;
  if (code == 960 && block_.has('d')) {
    modes_.most_speed = block_['d'];
    if (modes_.most_speed <= 0) refuse("G96 with D{}: the greatest speed must be above 0", modes_.most_speed);
  }
}

const ToolEntry& Interpreter::tool_entry(int tool) const {
  static const ToolEntry nothing;
  const auto found = options_.tools.find(tool);
  if (found != options_.tools.end()) return found->second;
  if (tool == 0) return nothing;
  refuse("tool {} is not in the tool table", tool);
}

void Interpreter::select_tool() {
  const int tool = whole(block_['t']);
  if (tool < 0) refuse("T{} is below 0", tool);
  if (tool != 0 && !options_.tools.contains(tool))
    notes_.add(flow_.line(), fmt::format("tool {} is not in the tool table", tool));
  selected_tool_ = tool;
}

void Interpreter::change_tool() {
  no_compensation("M6");
  tool_ = selected_tool_;
  modes_.spindle = 0;
  at_ = sent_;  // the actual position, not the programmed end of a compensated path
  Motion motion = stamped(Motion::Kind::tool_change);
  motion.end = at_;
  give(motion);
}

void Interpreter::do_modal_m() {
  const ModalWords& set = command_.modal;
  const int tool = block_.code(MGroup::tool);
  if (tool == 6) change_tool();
  if (tool == 61) {
    if (!block_.has('q')) refuse("M61 needs Q, the tool's number");
    const int number = whole(block_['q']);
    if (number < 0) refuse("M61 with Q{}, which is below 0", number);
    tool_ = number;
    Motion motion = stamped(Motion::Kind::tool_change);
    motion.end = at_;
    give(motion);
  }
  if (set.spindle) modes_.spindle = *set.spindle;
  if (const int code = block_.code(MGroup::coolant); code != Block::none) {
    modes_.mist = code == 7 || (code == 8 && modes_.mist);
    modes_.flood = code == 8 || (code == 7 && modes_.flood);
  }
  if (const int code = block_.code(MGroup::override_); code == 48 || code == 49)
    modes_.feed_override = modes_.speed_override = code == 48;
  if (const int code = block_.code(MGroup::in_out); code != Block::none) {
    if (code == 66)
      notes_.add(flow_.line(), "M66 waits for an input: it is taken as not there (#5399 is -1)");
    else
      notes_.add(flow_.line(), fmt::format("M{} sets an output: passed over", code));
  }
  switch (block_.code(MGroup::state)) {
    case 70: save_state(false); break;
    case 71: saved_.reset(); break;
    case 72:
      if (!saved_) refuse("M72 where M70 has saved nothing");
      restore_state(*saved_);
      break;
    case 73: save_state(true); break;
    default: break;
  }
  if (set.control) set_control(*set.control);
  if (const int code = block_.code(MGroup::user); code != Block::none)
    notes_.add(flow_.line(), fmt::format("M{} has no meaning here: passed over", code));
}

void Interpreter::set_control(ControlMode mode) {
  no_compensation("a change of kinematics");
  mode_ = mode;
  tip_by_length_ = false;
}

void Interpreter::save_state(bool restore_on_return) {
  modes_.axis_offset = parameters_.stored(number::offset_active) != 0;
  if (!restore_on_return) {
    saved_ = modes_;
  } else if (flow_.in_program()) {
    notes_.add(flow_.line(), "M73 outside of a subroutine does nothing");
  } else if (saved_in_calls_.empty() || saved_in_calls_.back().depth != flow_.depth()) {
    saved_in_calls_.push_back({flow_.depth(), modes_});
  }
}

void Interpreter::restore_state(const Modes& saved) {
  if (compensation_.side != 0) refuse("modes cannot be restored while cutter compensation is on");
  const int motion = modes_.motion;
  change_frame([&] {
    modes_ = saved;
    parameters_.stored(number::coordinate_system) = saved.system;
    parameters_.stored(number::offset_active) = saved.axis_offset ? 1 : 0;
    read_system();
    frame_.tool = saved.tool_offset;
  });
  modes_.motion = motion;
}

void Interpreter::set_plane(ArcPlane plane) {
  if (plane != modes_.plane) no_compensation("a change of plane");
  modes_.plane = plane;
}

void Interpreter::dwell(double seconds) {
  if (seconds < 0) refuse("a dwell of {} seconds", seconds);
  Motion motion = stamped(Motion::Kind::dwell);
  motion.end = at_;
  motion.seconds = seconds;
  give(motion);
}

void Interpreter::do_stop() {
  const int code = block_.code(MGroup::stop);
  if (code == 0 || code == 1 || code == 60) {
    Motion motion = stamped(Motion::Kind::stop);
    motion.end = at_;
    give(motion);
  } else if (code == 2 || code == 30) {
    end_program();
  } else if (code == 98) {
    if (!block_.has('p')) refuse("M98 needs P, the program's number");
    const int repeats = block_.has('l') ? whole(block_['l']) : 1;
    if (repeats < 0) refuse("M98 with L{}, which is below 0", repeats);
    flow_.call_program(whole(block_['p']), repeats);
  } else if (code == 99) {
    if (!flow_.return_program()) {
      notes_.add(flow_.line(), "M99 in the main program would begin it anew for ever: it ends here");
      end_program();
    }
  }
}

void Interpreter::end_program() {
  flush();
  compensation_ = {};
  Motion motion = stamped(Motion::Kind::end);
  motion.end = at_;
  give(motion);
  finished_ = true;
}

double Interpreter::numbered(int number) const {
  const double unit = this->unit();
  if (number == number::tool) return tool_;
  if (number >= 5401 && number <= 5403) return tool_entry(tool_).offset[number - 5401] / unit;
  if (number == 5410) return tool_entry(tool_).diameter / unit;
  if (number >= 5420 && number <= 5428) {
    if (compensation_.side != 0) refuse("the position cannot be asked for while cutter compensation is on");
    const auto axis = static_cast<std::size_t>(number - 5420);
    return axis >= 3 && axis < 6 ? at_.at[axis] : at_.at[axis] / unit;
  }
  return 0;
}

std::optional<double> Interpreter::named(std::string_view name) const {
  const auto flag = [](bool on) { return on ? 1.0 : 0.0; };
  constexpr std::string_view axes = "xyzabcuvw";
  if (name.size() == 2 && axes.find(name[1]) != std::string_view::npos)
    return numbered(5420 + static_cast<int>(axes.find(name[1])));
  if (name.size() == 6 && name.starts_with("_abs_") && axes.find(name[5]) != std::string_view::npos) {
    const std::size_t axis = axes.find(name[5]);
    const double value = frame_.axes(at_).at[axis];
    return axis >= 3 && axis < 6 ? value : value / unit();
  }
  if (name == "_vmajor") return 2.9;
  if (name == "_vminor") return 0;
  if (name == "_line") return flow_.line();
  if (name == "_motion_mode") return modes_.motion;
  if (name == "_plane") return modes_.plane == ArcPlane::xy ? 170 : modes_.plane == ArcPlane::zx ? 180 : 190;
  if (name == "_ccomp") return compensation_.side == 0 ? 400 : compensation_.side > 0 ? 410 : 420;
  if (name == "_metric") return flag(!modes_.inch);
  if (name == "_imperial") return flag(modes_.inch);
  if (name == "_absolute") return flag(modes_.absolute);
  if (name == "_incremental") return flag(!modes_.absolute);
  if (name == "_inverse_time") return flag(modes_.feed_mode == 930);
  if (name == "_units_per_minute") return flag(modes_.feed_mode == 940);
  if (name == "_units_per_rev") return flag(modes_.feed_mode == 950);
  if (name == "_coord_system") return modes_.system <= 6 ? 530 + 10 * modes_.system : 584 + modes_.system;
  if (name == "_tool_offset") return flag(frame_.tool != AxisValues{});
  if (name == "_retract_r_plane") return flag(!modes_.retract_to_start);
  if (name == "_retract_old_z") return flag(modes_.retract_to_start);
  if (name == "_spindle_rpm_mode") return flag(!modes_.constant_surface);
  if (name == "_spindle_css_mode") return flag(modes_.constant_surface);
  if (name == "_ijk_absolute_mode") return flag(modes_.arcs_absolute);
  if (name == "_lathe_diameter_mode") return flag(modes_.diameter);
  if (name == "_lathe_radius_mode") return flag(!modes_.diameter);
  if (name == "_spindle_on") return flag(modes_.spindle != 0);
  if (name == "_spindle_cw") return flag(modes_.spindle > 0);
  if (name == "_mist") return flag(modes_.mist);
  if (name == "_flood") return flag(modes_.flood);
  if (name == "_feed_override") return flag(modes_.feed_override);
  if (name == "_speed_override") return flag(modes_.speed_override);
  if (name == "_adaptive_feed" || name == "_feed_hold" || name == "_task" || name == "_remap_level") return 0;
  if (name == "_feed") return modes_.feed;
  if (name == "_rpm") return modes_.speed;
  if (name == "_current_tool") return tool_;
  if (name == "_current_pocket") return tool_;
  if (name == "_selected_tool" || name == "_selected_pocket") return selected_tool_;
  if (name == "_value") return flow_.value();
  if (name == "_value_returned") return flag(flow_.value_returned());
  if (name == "_call_level") return static_cast<double>(flow_.depth());
  if (name.starts_with("_hal[") || name.starts_with("_ini[")) {
    notes_.add(flow_.line(), fmt::format("#<{}> is 0: there is no such thing here", shown(name)));
    return 0;
  }
  return std::nullopt;
}

}  // namespace gcode
}  // namespace fieldfab::cam
