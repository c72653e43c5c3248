// Programs as text, by the templates of a machine's data file (docs/machines.md).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/chords.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "kinematics.h"
#include "templates.h"
#include "writers.h"

namespace fieldfab::cam {
namespace {

const char* coolant_template(Coolant coolant) {
  switch (coolant) {
    case Coolant::mist: return "coolant_mist";
    case Coolant::flood: return "coolant_flood";
    case Coolant::none: break;
  }
  return "coolant_off";
}

/// A hole that a tool drills straight down at the place where it is, and leaves to the height where it was.
struct DrilledHole {
  std::size_t moves;  ///< number of moves that drill it
  double from;        ///< height to which the tool is rapid, mm
  double bottom;      ///< z of the hole's bottom, mm
  double peck;        ///< depth of each peck, mm; 0: one motion
  double feed;        ///< mm/min
};

/// Recognises a hole in the moves from `first` on, of a tool at `at`: a rapid downwards, one or more motions downwards
/// with motions up between them, and a rapid up.
std::optional<DrilledHole> drilled_hole(const std::vector<Move>& moves, std::size_t first, const Vec3& at) {
  const auto upright = [&](const Move& move) {
    return move.bulge == 0 && move.axis == Vec3::UnitZ() && (move.to - at).head<2>().norm() < 1e-9;
  };
  std::size_t i = first;
  if (i + 2 >= moves.size() || !moves[i].rapid() || !upright(moves[i]) || !(moves[i].to.z() < at.z())) return {};
  DrilledHole hole{0, moves[i].to.z(), moves[i].to.z(), 0, moves[i + 1].feed};
  double z = hole.from;
  std::vector<double> depths;  // where the tool turns
  for (++i; i < moves.size() && !moves[i].rapid(); ++i) {
    if (!upright(moves[i])) return {};
    const bool down = moves[i].to.z() < z;
    if (down && moves[i].feed != hole.feed) return {};
    if (!down && (depths.empty() || depths.back() != z)) depths.push_back(z);
    z = moves[i].to.z();
    hole.bottom = std::min(hole.bottom, z);
  }
  const bool left = i < moves.size() && upright(moves[i]) && std::abs(moves[i].to.z() - at.z()) < 1e-9;
  if (!left || z != hole.bottom || !(hole.bottom < hole.from)) return {};
  if (!depths.empty()) {
    // The first depth counts from the top of the material, which pecks return to.
    hole.peck = (depths.front() - hole.bottom) / static_cast<double>(depths.size());
  }
  hole.moves = i + 1 - first;
  return hole;
}

/// Writes one program.
class TextWriter {
 public:
  TextWriter(const Program& program, const Machine& machine, const Values& values)
      : program_(program), machine_(machine), values_(values), templates_(machine), solver_(machine.kinematics) {}

  std::string write() {
    set_settings();
    const Section* const first = program_.sections.empty() ? nullptr : &program_.sections.front();
    set_section(first != nullptr ? *first : Section{});
    set_head();
    out_ += templates_.fill("header");
    int tool = -1;
    double spindle = -1;
    Coolant coolant = Coolant::none;
    for (const Section& section : program_.sections) {
      set_section(section);
      out_ += templates_.fill("section");
      if (!section.setup.empty()) {
        if (last_ && templates_.has("retract")) out_ += templates_.fill("retract");  // there must be room to turn it
        if (spindle > 0) out_ += templates_.fill("spindle_off");
        out_ += templates_.fill("setup");
        spindle = -1;
        templates_.forget();
        at_known_ = false;
      }
      if (section.tool.number != tool) {
        if (spindle > 0) out_ += templates_.fill("spindle_off");
        out_ += templates_.fill("tool_change");
        tool = section.tool.number;
        spindle = -1;
        templates_.forget();
        at_known_ = false;
      }
      if (section.spindle != spindle && section.spindle > 0) out_ += templates_.fill("spindle_on");
      spindle = section.spindle;
      if (section.coolant != coolant) out_ += templates_.fill(coolant_template(section.coolant));
      coolant = section.coolant;
      for (std::size_t i = 0; i < section.moves.size();) i += add_from(section, i);
    }
    stop_cutting();
    if (coolant != Coolant::none) out_ += templates_.fill(coolant_template(Coolant::none));
    if (spindle > 0) out_ += templates_.fill("spindle_off");
    out_ += templates_.fill("footer");
    return std::move(out_);
  }

 private:
  void set_settings() {
    for (const auto& [name, given] : values_.given) {
      if (const double* const number = std::get_if<double>(&given.value)) {
        templates_.set(name, *number);
        if (name == "xmin") offset_.x() = *number;
        if (name == "ymin") offset_.y() = *number;
      }
      if (const bool* const flag = std::get_if<bool>(&given.value)) templates_.set_whole(name, *flag ? 1 : 0);
      if (const auto* const text = std::get_if<std::string>(&given.value)) templates_.set_text(name, *text);
    }
    templates_.set_text("program", comment_safe(program_.name));
    for (const char* name : {"x", "y", "z", "i", "j", "f", "a", "b", "c", "cx", "cy", "turn", "radius"})
      templates_.set(name, 0);
  }

  void set_section(const Section& section) {
    templates_.set_text("operation", comment_safe(section.name));
    templates_.set_text("tool_name", comment_safe(section.tool.name));
    templates_.set_text("setup", comment_safe(section.setup));
    templates_.set_whole("tool", section.tool.number);
    templates_.set("diameter", section.tool.diameter / machine_.unit);
    templates_.set_whole("rpm", section.spindle);
    templates_.set("clearance", coordinate_value(section.clearance));
    coordinate("clearance", section.clearance);
    double slowest = 0;
    for (const Move& move : section.moves)
      if (!move.rapid() && (slowest == 0 || move.feed < slowest)) slowest = move.feed;
    templates_.set("slowest", slowest / machine_.feed_unit);
  }

  /// The lines of {head}: stock, zero, tools and time, for the person at the machine.
  void set_head() {
    templates_.set_text("head", "");
    if (!templates_.has("comment")) return;
    std::vector<std::string> lines;
    const Box& stock = program_.stock;
    if (const Vec3 size = stock.size(); stock.valid() && size.minCoeff() > 0) {
      lines.push_back(
          fmt::format("stock: {} x {} x {} {}", number(size.x()), number(size.y()), number(size.z()), unit()));
      lines.push_back(fmt::format("zero: {0} {4} from its left, {1} {4} from its front, {2} {4} {3} its top",
                                  number(-stock.lower.x()), number(-stock.lower.y()), number(std::abs(stock.upper.z())),
                                  stock.upper.z() >= 0 ? "below" : "above", unit()));
    }
    std::set<int> listed;
    double seconds = 0;
    for (const Section& section : program_.sections) {
      seconds += duration(section.moves, machine_.dynamics);
      if (listed.insert(section.tool.number).second && section.tool.diameter > 0)
        lines.push_back(tool_line(section.tool));
    }
    if (seconds > 0)
      lines.push_back(seconds < 90 ? fmt::format("time: about {:.0f} s", seconds)
                                   : fmt::format("time: about {:.0f} min", seconds / 60));
    std::string head;
    for (const std::string& line : lines) {
      templates_.set_text("comment", comment_safe(line));
      head += templates_.fill("comment");
    }
    templates_.set_text("head", std::move(head));
  }
  [[nodiscard]] std::string tool_line(const Tool& tool) const {
    const std::string name = tool.name.empty() ? std::string(name_of(tool.shape)) : tool.name;
    std::string line = fmt::format("T{}: {}, diameter {} {}", tool.number, name, number(tool.diameter), unit());
    if (tool.length > 0) line += fmt::format(", stickout {} {}", number(tool.length), unit());
    return line;
  }
  [[nodiscard]] bool inches() const { return machine_.unit == 25.4; }
  [[nodiscard]] const char* unit() const { return inches() ? "in" : "mm"; }
  /// A length in mm or in inches, for a person.
  [[nodiscard]] std::string number(double mm) const {
    return inches() ? number_text(mm / 25.4, 3) : number_text(mm, 2);
  }

  /// Text for a comment: without what ends one, and in ASCII, since controls refuse or garble other letters.
  static std::string comment_safe(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 15> letters{{{"ä", "ae"},
                                                                                            {"ö", "oe"},
                                                                                            {"ü", "ue"},
                                                                                            {"Ä", "Ae"},
                                                                                            {"Ö", "Oe"},
                                                                                            {"Ü", "Ue"},
                                                                                            {"ß", "ss"},
                                                                                            {"é", "e"},
                                                                                            {"è", "e"},
                                                                                            {"à", "a"},
                                                                                            {"ç", "c"},
                                                                                            {"ñ", "n"},
                                                                                            {"ø", "oe"},
                                                                                            {"å", "aa"},
                                                                                            {"×", "x"}}};
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
      const auto c = static_cast<unsigned char>(text[i]);
      const auto known = std::find_if(letters.begin(), letters.end(),
                                      [&](const auto& letter) { return text.substr(i).starts_with(letter.first); });
      if (known != letters.end()) {
        safe += known->second;
        i += known->first.size();
        continue;
      }
      const bool continues = (c & 0xc0) == 0x80;  // a further byte of a letter in UTF-8
      if (!continues) safe += c >= 128 ? '?' : c < 32 || c == '(' || c == ')' || c == ';' || c == '%' ? ' ' : text[i];
      ++i;
    }
    return safe;
  }

  [[nodiscard]] bool flat() const { return machine_.takes == MachineInput::flat_paths; }
  [[nodiscard]] double coordinate_value(double mm) const {
    return machine_.tick > 0 ? std::round(mm / machine_.tick) : mm / machine_.unit;
  }
  void coordinate(const std::string& name, double mm) {
    if (machine_.tick > 0)
      templates_.set_whole(name, coordinate_value(mm));
    else
      templates_.set(name, coordinate_value(mm));
  }

  [[nodiscard]] std::array<std::string, 3> as_written(const Vec3& p) const {
    std::array<std::string, 3> words;
    for (int axis = 0; axis < 3; ++axis)
      words[static_cast<std::size_t>(axis)] = number_text(coordinate_value(p[axis]), machine_.decimals);
    return words;
  }

  void stop_cutting() {
    if (cutting_) out_ += templates_.fill("end");
    cutting_ = false;
  }

  /// Writes a move or, by a drilling cycle, several. Returns their number.
  std::size_t add_from(const Section& section, std::size_t first) {
    const bool wanted = section.drills && (!values_.has("cycles") || values_.flag("cycles"));
    const auto hole = wanted && at_known_ && !solver_.tilts() ? drilled_hole(section.moves, first, at_) : std::nullopt;
    const char* const cycle = hole && hole->peck > 0 ? "peck_drill" : "drill";
    if (!hole || !templates_.has(cycle)) {
      add(section.moves[first], section);
      return 1;
    }
    stop_cutting();
    coordinate("x", at_.x() + offset_.x()), coordinate("y", at_.y() + offset_.y()), coordinate("from", hole->from);
    coordinate("bottom", hole->bottom), templates_.set("f", hole->feed / machine_.feed_unit);
    templates_.set("peck", hole->peck / machine_.unit);
    out_ += templates_.fill(cycle);
    return hole->moves;  // the tool is where it was
  }

  void add(const Move& move, const Section& section) {
    if (flat() && at_known_ && (move.to - at_).head<2>().norm() < 1e-9 && move.bulge == 0)
      return;  // vertical moves have no meaning there
    if (move.bulge != 0 && !(machine_.arcs && at_known_ && !solver_.tilts())) return add_arc_as_lines(move, section);
    const AxisPose pose = solver_.solve(move.to, move.axis, section.tool.length, last_);
    if (!move.rapid() && last_ && pose.angles != last_->angles && !machine_.kinematics.tip_mode) {
      if (strays(move, pose, section)) {
        const bool short_way = (move.to - at_).norm() + (move.axis - axis_).norm() < 1e-4;
        return short_way ? turn_on_the_spot(move, pose, section) : add_halves(move, section);
      }
    }
    write(move, pose);
  }

  void write(const Move& move, const AxisPose& pose) {
    check(pose.position);
    const bool turned = last_ && pose.angles != last_->angles;
    if (cutting_ && !move.rapid() && move.bulge == 0 && !turned &&
        as_written(pose.position) == as_written(last_->position))
      return;  // shorter than the last decimal
    for (std::size_t k = 0; k < solver_.axes().size(); ++k) {
      const std::string letter(1, static_cast<char>(std::tolower(solver_.axes()[k].letter)));
      templates_.set(letter, to_degrees(pose.angles[k]));
    }
    if (move.rapid()) {
      stop_cutting();
      // so that it is written again after a rapid
      if (templates_.has("feed")) templates_.set_text("f", "");
    } else {
      double feed = move.feed / machine_.feed_unit;
      if (turned) feed *= feed_factor(move, pose);
      const bool first = templates_.text("f") != number_text(feed, machine_.decimals);
      templates_.set("f", feed);
      if (first) out_ += templates_.fill("feed");
      if (!cutting_) out_ += templates_.fill("begin");
      cutting_ = true;
    }
    coordinate("x", pose.position.x() + offset_.x()), coordinate("y", pose.position.y() + offset_.y()),
        coordinate("z", pose.position.z());
    if (turned && templates_.has("tilt") && (pose.position - last_->position).norm() < 1e-9) {
      out_ += templates_.fill("tilt");
    } else if (move.bulge != 0) {
      const Arc arc = arc_between(at_.head<2>(), move.to.head<2>(), move.bulge);
      coordinate("i", arc.centre.x() - at_.x()), coordinate("j", arc.centre.y() - at_.y());
      coordinate("cx", arc.centre.x() + offset_.x()), coordinate("cy", arc.centre.y() + offset_.y()),
          coordinate("radius", arc.radius);
      templates_.set("turn", -to_degrees(arc.turn));
      out_ += templates_.fill(move.bulge > 0 ? "arc_ccw" : "arc_cw");
    } else if (move.rapid() && !at_known_ && templates_.has("retract")) {
      approach();
    } else {
      out_ += templates_.fill(move.rapid() ? "rapid" : "line");
    }
    at_ = move.to;
    axis_ = move.axis;
    at_known_ = true;
    last_ = pose;
  }

  /// The first move after a tool change, from an unknown place: up, over, and only then down.
  void approach() {
    out_ += templates_.fill("retract");
    const bool at_height = templates_.is_written("z");
    templates_.set_written("z");
    out_ += templates_.fill("rapid");
    if (at_height) return;
    templates_.forget("z");
    out_ += templates_.fill("rapid");
  }

  /// Whether the tip leaves the straight line when all axes move linearly to a pose.
  [[nodiscard]] bool strays(const Move& move, const AxisPose& pose, const Section& section) const {
    for (const double share : {0.25, 0.5, 0.75}) {
      AxisPose between{last_->position + share * (pose.position - last_->position), last_->angles};
      for (std::size_t k = 0; k < 2; ++k) between.angles[k] += share * (pose.angles[k] - last_->angles[k]);
      const Vec3 straight = at_ + share * (move.to - at_);
      if ((solver_.pose(between, section.tool.length).first - straight).norm() > 0.005) return true;
    }
    return false;
  }
  void add_halves(const Move& move, const Section& section) {
    Move half = move;
    half.to = 0.5 * (at_ + move.to);
    half.axis = (axis_ + move.axis).normalized();
    add(half, section);
    add(move, section);
  }
  /// Near singular poses (for example vertical above a table) a small rotation of the tool is a
  /// large one of the axes: they turn while the tip stays in place.
  void turn_on_the_spot(const Move& move, const AxisPose& pose, const Section& section) {
    const AxisPose from = *last_;
    const double most = std::max(std::abs(pose.angles[0] - from.angles[0]), std::abs(pose.angles[1] - from.angles[1]));
    const double reach = std::max((pose.position - from.position).norm(), 1.0);
    // The angle sqrt(8 tolerance / radius) is as fine as chords of circles about the axes require: compare
    // chord_arc_length().
    const int steps =
        std::max(1, static_cast<int>(std::ceil(
                        most / std::sqrt(8 * 0.002 / std::max(reach, (move.to - machine_.kinematics.centre).norm())))));
    for (int k = 1; k <= steps; ++k) {
      AxisPose next = pose;
      for (std::size_t i = 0; i < 2; ++i)
        next.angles[i] = from.angles[i] + (pose.angles[i] - from.angles[i]) * k / steps;
      next.position = solver_.position(move.to, next.angles, section.tool.length);
      write(move, next);
    }
  }
  /// Factor for the feed: controls measure it along the machine's x, y and z, but it is specified
  /// along the tip's path.
  [[nodiscard]] double feed_factor(const Move& move, const AxisPose& pose) const {
    const double tip = (move.to - at_).norm(), machine = (pose.position - last_->position).norm();
    if (machine_.kinematics.tip_mode || tip < 1e-6 || machine < 1e-6) return 1;
    const double most = machine_.max_feed > 0 ? machine_.max_feed / move.feed : 1e300;
    return std::min({machine / tip, most, 20.0});
  }

  void add_arc_as_lines(const Move& move, const Section& section) {
    if (!at_known_) throw Error(ErrorKind::internal, "program", "begins with an arc");
    const Arc arc = arc_between(at_.head<2>(), move.to.head<2>(), move.bulge);
    // The sagitta of a chord is at most 0.005 mm or half a tick.
    const double step = chord_arc_length(arc.radius, std::max(0.005, machine_.tick / 2));
    Path piece;
    piece.points = {{at_, move.bulge}, {move.to}};
    const std::vector<PathPoint> points = points_along(piece, step);
    for (std::size_t i = 1; i < points.size(); ++i) add({points[i].at, move.feed, 0, move.axis}, section);
  }

  void check(const Vec3& p) {
    if (!machine_.negative && (p.head<2>() + offset_).minCoeff() < -1e-6)
      throw Error(
          ErrorKind::bad_input, "machine",
          fmt::format("{} knows no places below 0; this program goes to x {:.6g}, y {:.6g}: set zero = \"corner\" for "
                      "the input, or xmin and ymin",
                      machine_.name, p.x() + offset_.x(), p.y() + offset_.y()));
    range_.lower = started_ ? Vec3(range_.lower.cwiseMin(p)) : p;
    range_.upper = started_ ? Vec3(range_.upper.cwiseMax(p)) : p;
    started_ = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double travel = machine_.travel[static_cast<std::size_t>(axis)], used = range_.size()[axis];
      if (travel > 0 && used > travel + 1e-6)
        throw Error(ErrorKind::bad_input, "machine",
                    fmt::format("{} can move {:.6g} mm along {}; this program needs {:.6g} mm or more", machine_.name,
                                travel, "xyz"[axis], used));
    }
  }

  const Program& program_;
  const Machine& machine_;
  const Values& values_;
  Templates templates_;
  PoseSolver solver_;
  std::string out_;
  Vec3 at_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  Vec2 offset_ = Vec2::Zero();  // position of the program's zero by the machine's settings
  bool at_known_ = false, started_ = false, cutting_ = false;
  Box range_;
  std::optional<AxisPose> last_;
};

}  // namespace

std::string number_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string write_text(const Program& program, const Machine& machine, const Values& values) {
  return TextWriter(program, machine, values).write();
}

}  // namespace fieldfab::cam
