// ShopBot's part files (OpenSBP): two-letter commands, labels, variables.
#include <algorithm>
#include <array>
#include <map>

#include "fieldfab/core/angle.h"
#include "sbp_values.h"
#include "simple_machine.h"

namespace fieldfab::cam {
namespace gcode {
namespace {

using namespace sbp;

constexpr std::size_t deepest_gosub = 100;

class SbpReader {
 public:
  SbpReader(std::string_view text, SimpleMachine& machine, double unit) : text_(text), machine_(machine), unit_(unit) {}

  void run() {
    find_labels();
    std::string_view line;
    while (!ended_ && next_line(line)) carry_out(line);
    if (!ended_) machine_.notes.add(machine_.line, "the program ends without END");
  }

 private:
  struct Place {
    std::size_t offset = 0;
    int line = 0;
  };

  bool next_line(std::string_view& line) {
    if (at_.offset >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', at_.offset), text_.size());
    line = text_.substr(at_.offset, end - at_.offset);
    at_.offset = end + 1;
    machine_.line = ++at_.line;
    machine_.count(static_cast<double>(at_.offset) / static_cast<double>(text_.size()));
    line = trimmed(line.substr(0, line.find('\'')));
    return true;
  }
  static bool is_label(std::string_view line) {
    return line.size() > 1 && line.back() == ':' &&
           std::all_of(line.begin(), line.end() - 1, [](char c) { return letter(c) || digit(c); });
  }
  void find_labels() {
    for (std::size_t offset = 0; offset < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', offset), text_.size());
      std::string_view line = text_.substr(offset, end - offset);
      ++at_.line;
      offset = end + 1;
      line = trimmed(line.substr(0, line.find('\'')));
      if (is_label(line)) labels_.emplace(upper(line.substr(0, line.size() - 1)), Place{offset, at_.line});
    }
    at_ = {};
  }

  // ---------- Statements
  void carry_out(std::string_view line) {
    if (line.empty() || is_label(line)) return;
    if (line.front() == '&') return assign(line);
    std::size_t length = 0;
    while (length < line.size() && (letter(line[length]) || digit(line[length]) || line[length] == '#')) ++length;
    const std::string word = upper(line.substr(0, length));
    std::string_view rest = trimmed(line.substr(length));
    if (!rest.empty() && rest.front() == ',') rest.remove_prefix(1);
    if (word == "IF") return conditional(rest);
    if (word == "GOTO") return go_to(rest);
    if (word == "GOSUB") {
      if (returns_.size() >= deepest_gosub) refuse("more than {} GOSUB within each other", deepest_gosub);
      returns_.push_back(at_);
      return go_to(rest);
    }
    if (word == "RETURN") {
      if (returns_.empty()) refuse("RETURN without GOSUB");
      at_ = returns_.back();
      returns_.pop_back();
      return;
    }
    if (word == "END" || word == "STOP") {
      machine_.say(Motion::Kind::end);
      ended_ = true;
      return;
    }
    if (word == "PAUSE") {
      rest = trimmed(rest);
      if (rest.empty() || letter(rest.front()) || rest.front() == '"')
        machine_.say(Motion::Kind::stop);
      else
        machine_.dwell(values_.value(rest));
      return;
    }
    command(word, rest, line);
  }
  void assign(std::string_view line) {
    const std::string name = variable_name(line);
    line = trimmed(line);
    if (line.empty() || line.front() != '=') refuse("'=' is missing behind &{}", shown(name));
    line = trimmed(line.substr(1));
    if (!line.empty() && (line.front() == '"' || line.front() == '%' || (letter(line.front())))) {
      values_.forget(name);
      machine_.notes.add(machine_.line, fmt::format("&{} is given something that is not known here", shown(name)));
      return;
    }
    const double number = values_.value(line);
    values_.set(name, number);
    if (name == "TOOL" && number >= 0 && number < 1e6 && static_cast<int>(number) != machine_.tool) {
      machine_.tool = static_cast<int>(number);
      machine_.say(Motion::Kind::tool_change);
    }
  }
  void conditional(std::string_view rest) {
    if (++nested_ > 10) refuse("more than 10 IF within each other");
    const std::size_t then = upper(rest).find("THEN");
    if (then == std::string::npos) refuse("IF without THEN");
    const std::string_view test = trimmed(rest.substr(0, then)), action = trimmed(rest.substr(then + 4));
    if (test.find('%') != std::string_view::npos) {
      machine_.notes.add(machine_.line,
                         fmt::format("IF {}: what the control knows is not known here; taken as not so", shown(test)));
      nested_ = 0;
      return;
    }
    if (values_.condition(test)) carry_out(action);
    nested_ = 0;
  }
  void go_to(std::string_view rest) {
    const std::string label = upper(trimmed(rest));
    const auto found = labels_.find(label);
    if (found == labels_.end()) refuse("there is no label {}", shown(label));
    at_ = found->second;
  }

  // ---------- Commands
  static std::vector<std::string_view> fields_of(std::string_view rest) {
    std::vector<std::string_view> fields;
    while (!rest.empty()) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      fields.push_back(trimmed(rest.substr(0, comma)));
      if (comma == rest.size()) break;
      rest.remove_prefix(comma + 1);
      if (fields.size() > 100) refuse("a command with more than 100 parameters");
    }
    return fields;
  }
  std::optional<double> field(std::size_t index) {
    if (index >= fields_.size() || fields_[index].empty()) return std::nullopt;
    return values_.value(fields_[index]);
  }

  void command(const std::string& word, std::string_view rest, std::string_view line) {
    fields_ = fields_of(rest);
    const char first = word.empty() ? '\0' : word[0], second = word.size() > 1 ? word[1] : '\0';
    if (word.size() == 2 && (first == 'M' || first == 'J') && second != 'S') return straight(word);
    if (word == "MS" || word == "VS") {
      for (std::size_t k = 0; k < 4; ++k)
        if (const auto speed = field(k)) {
          if (*speed <= 0) refuse("{} with a speed of {}", word, *speed);
          speeds_[k] = *speed * 60 * (k < 2 ? unit_ : 1 / degrees_per_radian);
        }
    } else if (word == "SA" || word == "SR") {
      relative_ = word == "SR";
    } else if (word == "CG") {
      circle_to();
    } else if (word == "CP") {
      circle_about();
    } else if (word == "SO") {
      const auto output = field(0), state = field(1);
      if (output && *output == 1 && state)
        machine_.spindle = *state != 0 ? std::max(speed_, 1.0) : 0;
      else
        machine_.notes.add(machine_.line, "SO switches an output: passed over");
    } else if (word == "TR") {
      if (const auto speed = field(0)) {
        if (*speed < 0) refuse("TR with a speed of {}", *speed);
        speed_ = *speed;
        if (machine_.spindle != 0) machine_.spindle = std::max(speed_, 1.0);
      }
    } else if (first == 'Z' && word.size() == 2) {
      zero(second);
    } else if (word == "VA") {
      AxisValues place = machine_.at();
      for (std::size_t k = 0; k < 5; ++k)
        if (const auto given = field(k)) place.at[k] = *given * scale(k);
      if (fields_.size() > 5) machine_.notes.add(machine_.line, "VA: what follows the five axes is passed over");
      machine_.call_it(place);
    } else if (word == "CC" || word == "CR" || word == "CA" || word == "FP" || word == "ST" || word == "SV" ||
               word == "FC" || word == "FG") {
      refuse("{} moves the machine, but is not known here", word);
    } else if (first == 'C' && word.size() >= 2 && (digit(second) || second == '#' || second == 'N')) {
      machine_.notes.add(machine_.line, fmt::format("the macro {} of the control is passed over", shown(line)));
    } else if (word == "JS" || word == "VR" || word == "VC" || word == "VU" || word == "VD" || word == "VL" ||
               word == "VI" || word == "VO" || word == "VP" || word == "VN" || word == "SF" || word == "SW" ||
               word == "SC" || word == "SM" || word == "SP" || word == "SL" || word == "ON" || word == "PRINT" ||
               word == "MSGBOX" || word == "WRITE" || word == "OPEN" || word == "CLOSE" || word == "INPUT") {
      if (word != "JS") machine_.notes.add(machine_.line, fmt::format("{} is passed over", word));
    } else {
      refuse("'{}' is not known here", shown(line));
    }
  }
  [[nodiscard]] double scale(std::size_t axis) const { return axis < 3 ? unit_ : 1 / degrees_per_radian; }

  /// M and J, with a number of axes, an axis letter, or H.
  void straight(const std::string& word) {
    AxisValues to = machine_.at();
    const auto set = [&](std::size_t axis, std::size_t index) {
      if (const auto given = field(index))
        to.at[axis] = *given * scale(axis) + (relative_ ? machine_.at().at[axis] : 0);
    };
    static constexpr std::string_view letters = "XYZABC";
    const char which = word[1];
    std::size_t count = 1;
    if (which >= '2' && which <= '6') {
      count = static_cast<std::size_t>(which - '0');
      for (std::size_t k = 0; k < count; ++k) set(k, k);
    } else if (which == 'H') {
      count = 0;
      to.at[0] = to.at[1] = 0;
    } else if (const std::size_t axis = letters.find(which); axis != std::string_view::npos) {
      set(axis, 0);
    } else {
      refuse("{} is not known here", word);
    }
    if (fields_.size() > count)
      for (std::size_t k = count; k < fields_.size(); ++k)
        if (!fields_[k].empty()) refuse("{} has more parameters than axes", word);
    if (word[0] == 'J')
      machine_.rapid(to);
    else
      machine_.feed(to, speed_to(to));
  }
  /// Speed of a move. Speeds are set for x and y together, and separately for z, a and b.
  double speed_to(const AxisValues& to) {
    const AxisValues& from = machine_.at();
    const auto moves = [&](std::size_t k) { return to.at[k] != from.at[k]; };
    const std::size_t which = moves(0) || moves(1) ? 0 : moves(2) ? 1 : moves(3) ? 2 : moves(4) || moves(5) ? 3 : 0;
    if (!speeds_[which]) {
      const double taken = which < 2 ? 1524 : 600 / degrees_per_radian;
      machine_.notes.add(machine_.line, which < 2 ? "a move before MS: 25.4 mm/s is taken"
                                                  : "no speed for a rotary axis: 10 degrees/s is taken");
      return taken;
    }
    return *speeds_[which];
  }

  struct Circle {
    Vec2 centre = Vec2::Zero(), end = Vec2::Zero();
    int direction = -1;
    double plunge = 0;
    int repeats = 1, feature = 0;
    bool stay_down = false, from_zero = false;
  };
  /// Parameters that CG and CP share. `first`: index of "inside, outside, true"; `later`: index of
  /// the plunge.
  void common(Circle& circle, std::size_t first, std::size_t later) {
    if (first < fields_.size() && !fields_[first].empty() && upper(fields_[first]) != "T")
      refuse("a circle inside or outside of the line needs the cutter's diameter, which is not known here");
    circle.direction = field(first + 1).value_or(1) < 0 ? 1 : -1;
    circle.plunge = field(later).value_or(0) * unit_;
    const double repeats = field(later + 1).value_or(1);
    if (!(repeats >= 0 && repeats <= 1e6)) refuse("a circle with {} repetitions", repeats);
    circle.repeats = static_cast<int>(repeats);
    for (const std::size_t k : {later + 2, later + 3})
      if (const auto share = field(k); share && *share != 1) refuse("a circle with a proportion of {}", *share);
    const double feature = field(later + 4).value_or(0);
    if (feature != 0 && feature != 3 && feature != 4) refuse("a circle with tabs or a pocket is not known here");
    circle.feature = static_cast<int>(feature);
    circle.stay_down = field(later + 5).value_or(0) != 0;
    circle.from_zero = field(later + 6).value_or(0) != 0;
  }
  /// CG: from the tool's position to an end point, about a centre relative to the start (or with a
  /// diameter).
  void circle_to() {
    Circle circle;
    const Vec2 from(machine_.at().at[0], machine_.at().at[1]);
    common(circle, 5, 7);
    const Vec2 base = relative_ ? from : Vec2(Vec2::Zero());
    circle.end = from;
    if (const auto x = field(1)) circle.end.x() = base.x() + *x * unit_;
    if (const auto y = field(2)) circle.end.y() = base.y() + *y * unit_;
    if (const auto diameter = field(0); diameter && !field(3) && !field(4)) {
      const Vec2 chord = circle.end - from;
      const double half = chord.norm() / 2, radius = std::abs(*diameter) * unit_ / 2;
      if (half == 0 || radius < half - 0.001) refuse("CG with a diameter of {} cannot reach its end", *diameter);
      const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
      circle.centre =
          (from + circle.end) / 2 + left * (circle.direction * std::sqrt(std::max(0.0, radius * radius - half * half)));
    } else {
      circle.centre = from + Vec2(field(3).value_or(0) * unit_, field(4).value_or(0) * unit_);
    }
    cut(circle);
  }
  /// CP: about a centre, between two angles that are clockwise from the top.
  void circle_about() {
    Circle circle;
    const auto diameter = field(0);
    if (!diameter || *diameter <= 0) refuse("CP needs a diameter above 0");
    common(circle, 3, 7);
    Vec2 centre(machine_.at().at[0], machine_.at().at[1]);
    const Vec2 base = relative_ ? centre : Vec2(Vec2::Zero());
    if (const auto x = field(1)) centre.x() = base.x() + *x * unit_;
    if (const auto y = field(2)) centre.y() = base.y() + *y * unit_;
    const double begin = field(5).value_or(0) / degrees_per_radian, end = field(6).value_or(360) / degrees_per_radian,
                 radius = *diameter * unit_ / 2;
    const auto on_circle = [&](double angle) { return Vec2(centre + radius * Vec2(std::sin(angle), std::cos(angle))); };
    circle.centre = centre;
    const Vec2 start = on_circle(begin);
    const bool whole = std::abs(std::remainder(end - begin, 2 * std::numbers::pi)) < 1e-9;
    circle.end = whole ? start : on_circle(end);
    AxisValues to = machine_.at();
    if ((start - Vec2(to.at[0], to.at[1])).norm() > 1e-6) {
      if (to.at[2] < 0)
        refuse(
            "CP away from where the tool is, and the tool is below 0: the height that the control pulls up to is not "
            "known here");
      machine_.notes.add(
          machine_.line,
          "CP: the control pulls up before it goes to the circle; the height that the tool has is taken");
      to.at[0] = start.x(), to.at[1] = start.y();
      machine_.rapid(to);
    }
    cut(circle);
  }
  void cut(const Circle& circle) {
    const AxisValues start = machine_.at();
    const Vec2 from(start.at[0], start.at[1]);
    const double radius = (from - circle.centre).norm(), radius_end = (circle.end - circle.centre).norm();
    if (radius < 1e-6) refuse("a circle with a radius of 0");
    if (std::abs(radius - radius_end) > 0.05 + 0.005 * radius)
      refuse("the arc begins {:.4f} mm from its centre and ends {:.4f} mm from it", radius, radius_end);
    const bool closed = (circle.end - from).norm() < 1e-9;
    const bool plunges = circle.plunge != 0;
    AxisValues place = start;
    const auto down = [&](double z) {
      place.at[2] = z;
      machine_.feed(place, speed_to(place));
    };
    if (plunges && circle.from_zero) down(0);
    double z = machine_.at().at[2];
    const auto arc = [&](double to) {
      place.at[0] = circle.end.x(), place.at[1] = circle.end.y(), place.at[2] = to;
      AxisValues aside = place;
      aside.at[0] += 1;
      machine_.arc(place, circle.centre, circle.direction, speed_to(aside));
    };
    const int rounds = circle.repeats + (circle.feature == 4 && plunges ? 1 : 0);
    for (int i = 0; i < rounds; ++i) {
      if (i > 0 && !closed) {
        if (start.at[2] <= z) refuse("an arc repeated from a height below it");
        place.at[2] = start.at[2];
        machine_.rapid(place);
        place.at[0] = from.x(), place.at[1] = from.y();
        machine_.rapid(place);
        down(z);
      }
      const bool spiral = circle.feature >= 3 && i < circle.repeats;
      if (plunges && circle.feature == 0) down(z += circle.plunge);
      if (spiral) z += circle.plunge;
      arc(z);
      machine_.count(0);
    }
    if (!circle.stay_down && z != start.at[2]) {
      place.at[2] = start.at[2];
      machine_.rapid(place);
    }
  }
  /// ZX, ZY, ZZ, ZA, ZB, Z2 to Z5: set the zero at the tool's position.
  void zero(char which) {
    static constexpr std::string_view letters = "XYZAB";
    AxisValues place = machine_.at();
    if (which >= '2' && which <= '5')
      std::fill_n(place.at.begin(), which - '0', 0.0);
    else if (const std::size_t axis = letters.find(which); axis != std::string_view::npos)
      place.at[axis] = 0;
    else
      refuse("Z{} is not known here", which);
    machine_.call_it(place);
  }

  std::string_view text_;
  SimpleMachine& machine_;
  double unit_;
  Place at_;
  bool ended_ = false, relative_ = false;
  std::map<std::string, Place> labels_;
  Values values_;
  std::vector<Place> returns_;
  int nested_ = 0;
  std::vector<std::string_view> fields_;
  std::array<std::optional<double>, 4> speeds_;
  double speed_ = 0;  // of the spindle
};

}  // namespace
}  // namespace gcode

std::vector<ReadingNote> read_sbp(std::string_view text, const std::string& file, const ReadingOptions& options,
                                  double unit, const MotionSink& sink, Progress& progress) {
  gcode::SimpleMachine machine(file, options, sink, progress);
  return machine.run([&] {
    if (!(unit > 0)) gcode::refuse("a unit of {} mm", unit);
    gcode::SbpReader(text, machine, unit).run();
  });
}

}  // namespace fieldfab::cam
