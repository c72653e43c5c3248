// RML of Roland's mills, and HPGL of plotters and cutters.
#include <algorithm>
#include <array>
#include <charconv>

#include "fieldfab/core/angle.h"
#include "simple_machine.h"

namespace fieldfab::cam {
namespace gcode {
namespace {

/// An instruction: a mnemonic and its numbers.
struct Instruction {
  std::string mnemonic;  ///< upper case, with '!', without '^'
  std::vector<double> numbers;
};

/// Splits a text into instructions. Letters start an instruction, numbers follow, ';' or the next
/// letter ends it.
class InstructionReader {
 public:
  InstructionReader(std::string_view text, SimpleMachine& machine) : text_(text), machine_(machine) {}

  /// Reads the next instruction. `letters` returns the length of a mnemonic from its first letter
  /// (RML has Z and H beside those of two letters).
  template <class Letters>
  bool next(Instruction& instruction, const Letters& letters) {
    instruction.mnemonic.clear();
    instruction.numbers.clear();
    skip_separators();
    if (done()) return false;
    machine_.count(static_cast<double>(at_) / static_cast<double>(text_.size()));
    if (text_[at_] == '^') ++at_;
    if (!done() && text_[at_] == '!') instruction.mnemonic.push_back(text_[at_++]);
    if (done() || !letter(text_[at_])) refuse("'{}' found where an instruction should be", shown(text_.substr(at_)));
    const std::size_t count = instruction.mnemonic.empty() ? letters(upper(text_[at_])) : 2;
    for (std::size_t i = 0; i < count && !done() && letter(text_[at_]); ++i)
      instruction.mnemonic.push_back(upper(text_[at_++]));
    read_numbers(instruction);
    return true;
  }
  /// Skips printer escapes with their data; files for cutters begin and end with them.
  bool skip_escape() {
    skip_separators();
    if (done()) return false;
    if (text_.substr(at_).starts_with("@PJL")) {
      while (!done() && text_[at_] != '\n' && text_[at_] != '\033') ++at_;
      return true;
    }
    if (text_[at_] != '\033') return false;
    ++at_;
    if (!done() && letter(text_[at_])) {
      ++at_;
      return true;
    }
    const bool data = text_.substr(at_).starts_with("!v");
    std::size_t number = 0;
    while (!done() && !(text_[at_] >= 'A' && text_[at_] <= 'Z')) {
      const char c = text_[at_++];
      number = c >= '0' && c <= '9' ? std::min<std::size_t>(number * 10 + static_cast<std::size_t>(c - '0'), 100'000)
                                    : number;
    }
    if (!done()) ++at_;
    if (data) at_ = std::min(text_.size(), at_ + number);  // number of bytes of data
    return true;
  }

 private:
  static bool letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
  static char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  void skip_separators() {
    while (!done() && (text_[at_] == ';' || text_[at_] == ',' || static_cast<unsigned char>(text_[at_]) <= 32) &&
           text_[at_] != '\033') {
      if (text_[at_] == '\n') ++machine_.line;
      ++at_;
    }
  }
  void read_numbers(Instruction& instruction) {
    while (true) {
      while (!done() && (text_[at_] == ',' || text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
      if (done()) return;
      const char c = text_[at_];
      if (!((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.')) return;
      if (c == '+') ++at_;
      double value = 0;
      const auto [end, error] =
          std::from_chars(text_.data() + at_, text_.data() + text_.size(), value, std::chars_format::fixed);
      if (error != std::errc() || !std::isfinite(value))
        refuse("'{}' found where a number should be", shown(text_.substr(at_)));
      at_ = static_cast<std::size_t>(end - text_.data());
      if (instruction.numbers.size() >= 1'000'000) refuse("an instruction with more than a million numbers");
      instruction.numbers.push_back(value);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  SimpleMachine& machine_;
};

void want(const Instruction& instruction, bool right, const char* what) {
  if (!right) refuse("{} needs {}", instruction.mnemonic, what);
}

/// RML: Z moves the tool in three axes; PU and PD move it up and down between two heights.
class RmlReader {
 public:
  RmlReader(SimpleMachine& machine, double tick) : machine_(machine), tick_(tick) {}

  void carry_out(const Instruction& in) {
    const auto& n = in.numbers;
    const std::string& name = in.mnemonic;
    if (name == "PA" || name == "PR") {
      relative_ = name == "PR";
      draw(in);
    } else if (name == "PU" || name == "PD") {
      down_ = name == "PD";
      level();
      draw(in);
    } else if (name == "M" || name == "D") {
      down_ = name == "D";
      level();
      draw(in);
    } else if (name == "Z") {
      want(in, !n.empty() && n.size() % 3 == 0, "x, y and z");
      for (std::size_t i = 0; i < n.size(); i += 3) go({n[i], n[i + 1], n[i + 2]});
    } else if (name == "VS" || name == "V" || name == "!VZ") {
      if (n.empty()) return;
      want(in, n.size() == 1 && n[0] > 0, "a speed above 0, in mm/s");
      (name == "!VZ" ? speed_z_ : speed_) = n[0] * 60;
    } else if (name == "!PZ") {
      want(in, n.size() <= 2, "one or two heights");
      if (!n.empty()) low_ = n[0] * tick_;
      if (n.size() > 1) high_ = n[1] * tick_;
    } else if (name == "!RC") {
      rpm_ = n.empty() ? 0 : n[0];
      if (machine_.spindle != 0) machine_.spindle = rpm_;
    } else if (name == "!MC") {
      const bool on = n.empty() || n[0] != 0;
      if (on && rpm_ <= 0)
        machine_.notes.add(machine_.line, "!MC1 without a speed by !RC: 1 revolution per minute stands for it");
      machine_.spindle = on ? std::max(rpm_, 1.0) : 0;
    } else if (name == "!DW" || name == "W") {
      want(in, n.size() == 1, "one number");
      machine_.dwell(n[0] / 1000);
    } else if (name == "H") {
      down_ = false;
      level();
      AxisValues home = machine_.at();
      home.at[0] = home.at[1] = 0;
      machine_.rapid(home);
    } else if (name == "!ZZ" || name == "!XX" || name == "AA" || name == "AR" || name == "CI" || name == "I" ||
               name == "R" || name == "A" || name == "EA" || name == "RA" || name == "ER" || name == "RR" ||
               name == "!ZM" || name == "!ZO" || name == "!ZE") {
      refuse("{} moves the machine, but is not known here", name);
    } else if (name != "IN" && name != "DF" && name != "!NR" && name != "SP" && name != "!ST") {
      machine_.notes.add(machine_.line, fmt::format("{} is passed over", shown(name)));
    }
  }

 private:
  /// Moves to x, y, z in ticks, at the lower of the two limits of speed.
  void go(const std::array<double, 3>& ticks) {
    AxisValues to = machine_.at();
    for (std::size_t k = 0; k < 3; ++k) to.at[k] = ticks[k] * tick_ + (relative_ ? machine_.at().at[k] : 0);
    const Vec3 way = to.xyz() - machine_.at().xyz();
    if (way.head<2>().norm() > 0 || way.z() == 0)
      machine_.feed(to, way.z() == 0 ? xy() : std::min(xy(), z()));
    else
      machine_.feed(to, z());
  }
  void draw(const Instruction& in) {
    want(in, in.numbers.size() % 2 == 0, "pairs of x and y");
    for (std::size_t i = 0; i < in.numbers.size(); i += 2) {
      AxisValues to = machine_.at();
      for (std::size_t k = 0; k < 2; ++k) to.at[k] = in.numbers[i + k] * tick_ + (relative_ ? machine_.at().at[k] : 0);
      if (down_)
        machine_.feed(to, xy());
      else
        machine_.rapid(to);
    }
  }
  /// Moves up or down, to the heights of !PZ.
  void level() {
    const std::optional<double>& height = down_ ? low_ : high_;
    if (!height) {
      if (down_) refuse("PD before !PZ has said how deep");
      return;
    }
    AxisValues to = machine_.at();
    to.at[2] = *height;
    if (to == machine_.at()) return;
    if (down_)
      machine_.feed(to, z());
    else
      machine_.rapid(to);
  }
  double xy() { return spoken(speed_); }
  double z() { return spoken(speed_z_ ? speed_z_ : speed_); }
  double spoken(const std::optional<double>& speed) {
    if (!speed) machine_.notes.add(machine_.line, "a move before VS: 3 mm/s is taken");
    return speed.value_or(180);
  }

  SimpleMachine& machine_;
  double tick_;
  bool relative_ = false, down_ = false;
  std::optional<double> low_, high_, speed_, speed_z_;
  double rpm_ = 0;
};

/// HPGL: a pen (or blade, or beam) that is up or down.
class HpglReader {
 public:
  HpglReader(SimpleMachine& machine, double tick, double up, double down)
      : machine_(machine), tick_(tick), up_(up), down_height_(down) {}

  void carry_out(const Instruction& in) {
    const auto& n = in.numbers;
    const std::string& name = in.mnemonic;
    if (name == "PU" || name == "PD") {
      down_ = name == "PD";
      draw(in);
    } else if (name == "PA" || name == "PR") {
      relative_ = name == "PR";
      draw(in);
    } else if (name == "AA" || name == "AR") {
      want(in, n.size() == 3 || n.size() == 4, "a centre and an angle");
      Vec2 centre(n[0] * tick_, n[1] * tick_);
      if (name == "AR") centre += at();
      arc(centre, n[2]);
    } else if (name == "CI") {
      want(in, !n.empty() && n.size() <= 2 && n[0] != 0, "a radius");
      circle(n[0] * tick_);
    } else if (name == "EA" || name == "ER") {
      want(in, n.size() == 2, "a corner");
      rectangle(Vec2(n[0] * tick_, n[1] * tick_) + (name == "ER" ? at() : Vec2(Vec2::Zero())));
    } else if (name == "VS") {
      if (n.empty()) return;
      want(in, n[0] > 0, "a speed above 0, in cm/s");
      speed_ = n[0] * 600;
    } else if (name == "SP") {
      const int pen = n.empty() ? 0 : static_cast<int>(std::clamp(n[0], 0.0, 1e6));
      if (pen == machine_.tool) return;
      down_ = false;
      level();
      machine_.tool = pen;
      machine_.say(Motion::Kind::tool_change);
    } else if (name == "IN" || name == "DF") {
      relative_ = false;
      if (name == "IN" && down_) {
        down_ = false;
        level();
      }
    } else if (moves(name) && !(n.empty() && (name == "SC" || name == "IP" || name == "RO" || name == "IW"))) {
      refuse("{} draws or changes where is drawn, but is not known here", name);
    } else {
      machine_.notes.add(machine_.line, fmt::format("{} is passed over", shown(name)));
    }
  }
  void finish() {
    if (down_) {
      down_ = false;
      level();
    }
  }

 private:
  static bool moves(const std::string& name) {
    static constexpr std::array<std::string_view, 20> known{"LB", "PE", "BZ", "BR", "AT", "RT", "EW", "WG", "RA", "RR",
                                                            "FP", "EP", "PM", "SM", "SC", "IP", "RO", "IW", "PB", "UC"};
    return std::find(known.begin(), known.end(), name) != known.end();
  }
  [[nodiscard]] Vec2 at() const { return {machine_.at().at[0], machine_.at().at[1]}; }
  double speed() {
    if (!speed_) machine_.notes.add(machine_.line, "no speed by VS: 20 mm/s is taken");
    return speed_.value_or(1200);
  }
  void level() {
    AxisValues to = machine_.at();
    to.at[2] = down_ ? down_height_ : up_;
    if (to == machine_.at()) return;
    if (down_)
      machine_.feed(to, speed());
    else
      machine_.rapid(to);
  }
  void line_to(const Vec2& place) {
    level();
    AxisValues to = machine_.at();
    to.at[0] = place.x(), to.at[1] = place.y();
    if (down_)
      machine_.feed(to, speed());
    else
      machine_.rapid(to);
  }
  void draw(const Instruction& in) {
    want(in, in.numbers.size() % 2 == 0, "pairs of x and y");
    if (in.numbers.empty()) level();
    for (std::size_t i = 0; i < in.numbers.size(); i += 2)
      line_to(Vec2(in.numbers[i] * tick_, in.numbers[i + 1] * tick_) + (relative_ ? at() : Vec2(Vec2::Zero())));
  }
  void arc(const Vec2& centre, double degrees) {
    const Vec2 from = at() - centre;
    if (degrees == 0 || from.norm() == 0) return;
    if (std::abs(degrees) > 360e6) refuse("an arc of {} degrees", degrees);
    const double angle = to_radians(degrees);
    const Vec2 to = centre + Vec2(std::cos(angle) * from.x() - std::sin(angle) * from.y(),
                                  std::sin(angle) * from.x() + std::cos(angle) * from.y());
    if (!down_) return line_to(to);
    level();
    AxisValues end = machine_.at();
    const double around = std::abs(degrees) / 360, turns = std::ceil(around - 1e-12);
    if (around != std::floor(around)) end.at[0] = to.x(), end.at[1] = to.y();
    machine_.arc(end, centre, static_cast<int>(turns) * (degrees > 0 ? 1 : -1), speed());
  }
  /// A circle about the pen's position, to which it returns.
  void circle(double radius) {
    const Vec2 centre = at();
    const bool was_down = down_;
    down_ = false;
    line_to(centre + Vec2(radius, 0));
    down_ = true;
    arc(centre, 360);
    down_ = false;
    line_to(centre);
    down_ = was_down;
    level();
  }
  void rectangle(const Vec2& corner) {
    const Vec2 from = at();
    const bool was_down = down_;
    down_ = true;
    for (const Vec2& place : {Vec2(corner.x(), from.y()), corner, Vec2(from.x(), corner.y()), from}) line_to(place);
    down_ = was_down;
    level();
  }

  SimpleMachine& machine_;
  double tick_, up_, down_height_;
  bool relative_ = false, down_ = false;
  std::optional<double> speed_;
};

void check_tick(double tick) {
  if (!(tick > 0)) refuse("a tick of {} mm", tick);
}

}  // namespace
}  // namespace gcode

std::vector<ReadingNote> read_rml(std::string_view text, const std::string& file, const ReadingOptions& options,
                                  double tick, const MotionSink& sink, Progress& progress) {
  gcode::SimpleMachine machine(file, options, sink, progress);
  return machine.run([&] {
    gcode::check_tick(tick);
    gcode::RmlReader reader(machine, tick);
    gcode::InstructionReader instructions(text, machine);
    gcode::Instruction instruction;
    const auto letters = [](char first) {
      return first == 'Z' || first == 'H' || first == 'M' || first == 'D' || first == 'W' ? 1U : 2U;
    };
    while (instructions.next(instruction, letters)) reader.carry_out(instruction);
    machine.say(Motion::Kind::end);
  });
}

std::vector<ReadingNote> read_hpgl(std::string_view text, const std::string& file, const ReadingOptions& options,
                                   double tick, double up, double down, const MotionSink& sink, Progress& progress) {
  gcode::SimpleMachine machine(file, options, sink, progress);
  return machine.run([&] {
    gcode::check_tick(tick);
    machine.spindle = 1;  // pens, blades and beams have no spindle that could be off
    gcode::HpglReader reader(machine, tick, up, down);
    gcode::InstructionReader instructions(text, machine);
    gcode::Instruction instruction;
    while (true) {
      while (instructions.skip_escape()) continue;
      if (!instructions.next(instruction, [](char) { return 2U; })) break;
      reader.carry_out(instruction);
    }
    reader.finish();
    machine.say(Motion::Kind::end);
  });
}

}  // namespace fieldfab::cam
