#include "fieldfab/cam/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/mapped_file.h"
#include "poses.h"

namespace fieldfab::cam {

using Kind = SimulationEvent::Kind;

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::rapid_contact: return "rapid contact";
    case Kind::shank_contact: return "shank contact";
    case Kind::holder_contact: return "holder contact";
    case Kind::fixture_contact: return "fixture contact";
    case Kind::over_travel: return "over-travel";
    case Kind::spindle_stopped: return "spindle stopped";
    case Kind::gouge: return "gouge";
    case Kind::excess: return "excess";
  }
  return "";
}

SimulationSetup::SimulationSetup() { limits.fill({-1e300, 1e300}); }

Simulation::Simulation(SimulationSetup setup, Progress& progress)
    : setup_(std::move(setup)),
      stock_(setup_.stock ? Stock(*setup_.stock, setup_.stock_box, setup_.sampling, progress)
                          : Stock(setup_.stock_box, setup_.sampling)) {
  if (setup_.fixture) fixture_.emplace(*setup_.fixture, setup_.fixture_box, setup_.sampling, progress);
}

/// Carries out a program: turns its motions into strokes, and what these meet into events.
class SimulationRun {
 public:
  SimulationRun(Simulation& simulation, const std::string& program, int lines, Progress& progress)
      : s_(simulation),
        setup_(simulation.setup_),
        poses_(setup_, program),
        program_(program),
        lines_(lines),
        progress_(progress) {
    at_ = setup_.start;
    placement_ = setup_.placement;
    // Without any word about tools, the only one there is.
    if (setup_.tools.size() == 1) take(setup_.tools.begin()->second);
  }

  void operator()(const Motion& motion) {
    ++s_.report_.moves;
    if (motion.tool != tool_number_ && motion.tool != 0 && !by_hand_) change_tool(motion.tool, motion.line);
    switch (motion.kind) {
      case Motion::Kind::rapid:
      case Motion::Kind::feed:
      case Motion::Kind::arc: move(motion); break;
      case Motion::Kind::dwell:
        record(motion.line).seconds += motion.seconds;
        s_.report_.seconds += motion.seconds;
        break;
      case Motion::Kind::stop: stop(motion); break;
      case Motion::Kind::tool_change:
      case Motion::Kind::end: break;
    }
  }

  void finish() { flush(); }

 private:
  /// What is to be done with the result of a stroke.
  struct Purpose {
    enum class What : std::uint8_t { cut, rapid, shank, holder, fixture } what;
    std::size_t record;
    int line, tool;
    double length;  ///< of the way, mm
    bool stopped;
  };
  /// A tool with what is asked about it.
  struct Mounted {
    Tool tool;
    ToolSolid solid, inner;  ///< as it is, and what lies deeper in it than contacts count
  };

  void take(const Tool& tool) {
    flush();  // strokes point into the tool that was there
    mounted_ = std::make_unique<Mounted>();
    mounted_->tool = tool;
    mounted_->solid = tool_solid(tool);
    mounted_->inner = mounted_->solid.shrunk(setup_.touch);
    tool_number_ = tool.number;
    known_ = false;  // nor is it said how the machine got to where tools are changed and back
  }

  void change_tool(int number, int line) {
    const auto found = setup_.tools.find(number);
    if (found == setup_.tools.end())
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", program_, line),
                  fmt::format("tool {} is not in the set-up, which has {}", number, tool_list()));
    take(found->second);
  }
  [[nodiscard]] std::string tool_list() const {
    std::vector<int> numbers;
    for (const auto& [number, tool] : setup_.tools) numbers.push_back(number);
    return numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, ", "));
  }

  void stop(const Motion& motion) {
    if (stops_ >= setup_.stops.size()) return;
    const StopAction& action = setup_.stops[stops_++];
    if (action.placement) {
      flush();
      placement_ = *action.placement;
      known_ = false;  // the part was turned: how the tool came to where it is means nothing
    }
    if (action.tool) change_tool(action.tool, motion.line), by_hand_ = true;
  }

  LineRecord& record(int line) {
    auto& lines = s_.report_.lines;
    if (lines.empty() || lines.back().line != line || lines.back().tool != tool_number_) {
      const auto [at, fresh] = record_of_line_.try_emplace({line, tool_number_}, lines.size());
      if (fresh) lines.push_back({line, tool_number_, 0, 0, 0, 0});
      record_ = at->second;
    } else
      record_ = lines.size() - 1;
    return lines[record_];
  }

  void event(Kind kind, int line, int tool, const Vec3& place, double amount, std::string message) {
    // One of a kind for each line: the worst.
    const auto [at, fresh] = event_of_.try_emplace({static_cast<int>(kind), line}, s_.report_.events.size());
    SimulationEvent made{kind, line, tool, place, amount, std::move(message)};
    if (fresh)
      s_.report_.events.push_back(std::move(made));
    else if (std::abs(amount) > std::abs(s_.report_.events[at->second].amount))
      s_.report_.events[at->second] = std::move(made);
  }

  void move(const Motion& motion) {
    poses_.check(motion);
    if (!mounted_ && setup_.first_tool == 0 && motion.kind == Motion::Kind::rapid) {
      at_ = motion.end;  // an empty spindle
      return;
    }
    if (!mounted_) {
      if (setup_.first_tool == 0 || !setup_.tools.contains(setup_.first_tool))
        throw Error(ErrorKind::bad_input, fmt::format("{}:{}", program_, motion.line),
                    fmt::format("no tool is in the spindle; the set-up has {}", tool_list()));
      s_.report_.notes.push_back({motion.line, fmt::format("the program names no tool: number {} is taken", setup_.first_tool)});
      take(setup_.tools.at(setup_.first_tool));
    }
    check_limits(motion);
    const bool rapid = motion.kind == Motion::Kind::rapid;
    const Tool& tool = mounted_->tool;
    double lengthened = 0;
    if (motion.tool_offset != Vec3::Zero()) lengthened = motion.tool_offset.z() - tool.length;
    const double tolerance = s_.stock_.tolerance();
    // The axes stand where they were, whatever the control now takes for the tool's length.
    AxisValues start = known_ ? at_ : motion.end;
    for (std::size_t a = 0; known_ && a < 3; ++a) {
      const auto i = static_cast<Eigen::Index>(a);
      start.at[a] += offset_[i] - motion.tool_offset[i];
    }
    const std::vector<ToolPose> way =
        poses_.along(start, motion, lengthened, tool.length, placement_, mounted_->solid.length(), tolerance);
    double length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) length += (way[i].tip - way[i - 1].tip).norm();
    const double seconds = duration_of(motion, length);
    LineRecord& line = record(motion.line);
    line.seconds += seconds;
    s_.report_.seconds += seconds;
    if (rapid) s_.report_.rapid_seconds += seconds, s_.report_.rapid += length;
    s_.line_of_cut_.push_back(motion.line);
    s_.line_of_cut_.push_back(-motion.line);  // by the shank
    s_.tool_of_cut_.resize(s_.line_of_cut_.size(), tool.number);
    const auto cut = static_cast<std::uint32_t>(s_.line_of_cut_.size() - 2);
    const bool stopped = motion.spindle == 0;
    const auto first = known_ ? way.begin() : way.end() - 1;
    for (auto from = first; from + 1 != way.end() || from == first; ++from) {
      if (from + 1 == way.end()) {
        if (known_) break;  // a motion without a way
        add(*from, *from, motion, rapid, cut, 0, stopped);
        break;
      }
      const ToolPose &a = *from, &b = *(from + 1);
      add(a, b, motion, rapid, cut, (b.tip - a.tip).norm(), stopped);
    }
    s_.report_.poses += way.size() - 1;
    at_ = motion.end;
    offset_ = motion.tool_offset;
    known_ = true;
    if (strokes_.size() >= 4096) {
      flush();
      progress_.report(lines_ > 0 ? std::min(1.0, static_cast<double>(motion.line) / lines_) : 0,
                       fmt::format("line {}", motion.line));
      progress_.check();
    }
  }

  void add(const ToolPose& from, const ToolPose& to, const Motion& motion, bool rapid, std::uint32_t cut, double length,
           bool stopped) {
    const auto stroke = [&](const ToolPiece& piece, bool removes, Purpose::What what) {
      strokes_.push_back({&piece, from, to, what == Purpose::What::shank ? cut + 1 : cut, removes});
      const bool first = &piece == &mounted_->solid.pieces.front();  // the way counts once
      purposes_.push_back({what, record_, motion.line, mounted_->tool.number, first ? length : 0, stopped});
    };
    // First what lies inside the tool, for rapids; then the cut; then what must not touch what is left.
    if (rapid)
      for (const ToolPiece& piece : mounted_->inner.pieces)
        if (piece.role == ToolRole::cutting) stroke(piece, false, Purpose::What::rapid);
    for (const ToolPiece& piece : mounted_->solid.pieces)
      if (piece.role == ToolRole::cutting) stroke(piece, true, rapid ? Purpose::What::rapid : Purpose::What::cut);
    for (const ToolPiece& piece : mounted_->inner.pieces) {
      if (piece.role == ToolRole::shank) stroke(piece, false, Purpose::What::shank);
      if (piece.role == ToolRole::holder) stroke(piece, false, Purpose::What::holder);
    }
    // A shank that was told of takes away what it met: what is left where it went is no further fault.
    for (const ToolPiece& piece : mounted_->solid.pieces)
      if (piece.role == ToolRole::shank) stroke(piece, true, Purpose::What::shank);
    if (!s_.fixture_) return;
    for (const ToolPiece& piece : mounted_->inner.pieces) {
      fixture_strokes_.push_back({&piece, from, to, cut, false});
      fixture_purposes_.push_back({Purpose::What::fixture, record_, motion.line, mounted_->tool.number, length, stopped});
    }
  }

  /// Carries out what was collected.
  void flush() {
    if (strokes_.empty()) return;
    const std::vector<StrokeResult> results = s_.stock_.cut(strokes_, progress_);
    for (std::size_t i = 0; i < results.size(); ++i) judge(strokes_[i], purposes_[i], results[i]);
    strokes_.clear();
    purposes_.clear();
    if (fixture_strokes_.empty()) return;
    const std::vector<StrokeResult> touched = s_.fixture_->cut(fixture_strokes_, progress_);
    for (std::size_t i = 0; i < touched.size(); ++i) judge(fixture_strokes_[i], fixture_purposes_[i], touched[i]);
    fixture_strokes_.clear();
    fixture_purposes_.clear();
  }

  void judge(const Stroke& stroke, const Purpose& purpose, const StrokeResult& result) {
    const auto told = [&](Kind kind, const char* what) {
      if (!result.points) return;
      event(kind, purpose.line, purpose.tool, result.place, result.volume,
            fmt::format("{}: {:.3g} mm3 at ({:.3f}, {:.3f}, {:.3f})", what, result.volume, result.place.x(), result.place.y(),
                        result.place.z()));
    };
    LineRecord& line = s_.report_.lines[purpose.record];
    switch (purpose.what) {
      case Purpose::What::cut:
        line.removed += result.volume, s_.report_.removed += result.volume;
        // Rubbing along what is there is air: less than a chip of a hundredth by a hundredth of a millimetre.
        (result.volume > 1e-4 * purpose.length ? line.cut : line.air) += purpose.length;
        (result.volume > 1e-4 * purpose.length ? s_.report_.cut : s_.report_.air) += purpose.length;
        if (purpose.stopped) told(Kind::spindle_stopped, "it cuts while the spindle stands");
        break;
      case Purpose::What::rapid:
        if (stroke.removes)
          line.removed += result.volume, s_.report_.removed += result.volume;
        else
          told(Kind::rapid_contact, "a rapid goes through material");
        break;
      case Purpose::What::shank:
        if (!stroke.removes) told(Kind::shank_contact, "the shank meets material");
        break;
      case Purpose::What::holder: told(Kind::holder_contact, "the holder meets material"); break;
      case Purpose::What::fixture: told(Kind::fixture_contact, "the tool meets a fixture"); break;
    }
  }

  /// Arcs may leave the limits between their ends. Coming back from beyond a limit is no further fault.
  void check_limits(const Motion& motion) {
    const std::vector<AxisValues> stations = poses_.places(known_ ? at_ : motion.end, motion, s_.stock_.tolerance());
    for (std::size_t axis = 0; axis < 9; ++axis) {
      const auto& [low, high] = setup_.limits[axis];
      const auto beyond = [&](const AxisValues& place) { return std::max(low - place.at[axis], place.at[axis] - high); };
      const double before = beyond(stations.front());
      for (std::size_t i = 1; i < stations.size(); ++i) {
        const double excess = beyond(stations[i]);
        const bool end = i + 1 == stations.size();
        if (excess <= 1e-6 || (!end && excess <= before)) continue;
        const double unit = axis >= 3 && axis < 6 ? 180 / std::numbers::pi : 1;
        event(Kind::over_travel, motion.line, tool_number_, stations[i].xyz() - setup_.zero, excess * unit,
              fmt::format("{} goes to {:.6g}, beyond its limits {:.6g} to {:.6g}", "XYZABCUVW"[axis], stations[i].at[axis] * unit,
                          low * unit, high * unit));
      }
    }
  }

  /// Of a motion whose tip goes `length` mm on the part.
  [[nodiscard]] double duration_of(const Motion& motion, double length) const {
    if (motion.seconds > 0) return motion.seconds;
    double linear = 0, turned = 0;
    for (std::size_t a = 0; a < 3; ++a) linear += std::pow(motion.end.at[a] - at_.at[a], 2);
    for (std::size_t a = 3; a < 6; ++a) turned = std::max(turned, std::abs(motion.end.at[a] - at_.at[a]));
    linear = motion.kind == Motion::Kind::arc ? length : std::sqrt(linear);
    if (!known_) return 0;
    if (motion.kind == Motion::Kind::rapid) {
      constexpr double turning = 3600 * std::numbers::pi / 180;  // radians/min, where nothing is said about it
      return 60 * std::max(linear / std::max(setup_.machine.dynamics.rapid, 1.0), turned / turning);
    }
    if (motion.feed <= 0) return 0;
    return 60 * (linear > 1e-9 ? linear : turned) / motion.feed;
  }

  Simulation& s_;
  const SimulationSetup& setup_;
  PoseMaker poses_;
  std::string program_;
  int lines_;
  Progress& progress_;
  std::unique_ptr<Mounted> mounted_;
  int tool_number_ = 0;
  AxisValues at_;
  Vec3 offset_ = Vec3::Zero();  ///< the length compensation that was in force there
  bool known_ = false;          ///< whether the way to the next place is known: not before the first motion
  Placement placement_;
  bool by_hand_ = false;  ///< tools are changed at stops, whatever the program's numbers are
  std::size_t stops_ = 0, record_ = 0;
  std::vector<Stroke> strokes_, fixture_strokes_;
  std::vector<Purpose> purposes_, fixture_purposes_;
  std::map<std::pair<int, int>, std::size_t> record_of_line_;  ///< and tool
  std::map<std::pair<int, int>, std::size_t> event_of_;
};

namespace {

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

void Simulation::run(const std::filesystem::path& program, Progress& progress) {
  const MappedFile file(program);
  program_ = program;
  const std::string_view text(reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size());
  const std::string name = program.string(), extension = lower_case(program.extension().string());
  const auto lines = static_cast<int>(std::min<std::ptrdiff_t>(std::count(text.begin(), text.end(), '\n') + 1, 2'000'000'000));
  ReadingOptions options;
  options.work_offsets = setup_.work_offsets;
  options.start = setup_.start;
  options.home = setup_.home;
  options.most_blocks = 10'000'000 + 10 * static_cast<std::uint64_t>(lines);
  for (const auto& [number, tool] : setup_.tools) options.tools[number] = {Vec3(0, 0, tool.length), tool.diameter};
  SimulationRun run(*this, name, lines, progress);
  const MotionSink sink = [&](const Motion& motion) { run(motion); };
  const Machine& machine = setup_.machine;
  std::vector<ReadingNote> notes;
  if (extension == ".sbp")
    notes = read_sbp(text, name, options, machine.unit, sink, progress);
  else if (extension == ".rml")
    notes = read_rml(text, name, options, machine.tick > 0 ? machine.tick : 0.025, sink, progress);
  else if (extension == ".plt" || extension == ".hpgl" || extension == ".camm")
    notes = read_hpgl(text, name, options, machine.tick > 0 ? machine.tick : 0.025, 1, -1, sink, progress);
  else
    notes = read_gcode(text, name, options, sink, progress);
  run.finish();
  report_.notes.insert(report_.notes.begin(), notes.begin(), notes.end());
}

void Simulation::finish(Progress& progress) {
  std::vector<std::uint32_t> cuts;
  mesh_ = stock_.mesh(&cuts, progress);
  vertex_lines_.resize(cuts.size()), vertex_tools_.resize(cuts.size());
  std::vector<bool> by_shank(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const std::size_t cut = std::min<std::size_t>(cuts[i], line_of_cut_.size() - 1);
    vertex_lines_[i] = std::abs(line_of_cut_[cut]), vertex_tools_[i] = tool_of_cut_[cut], by_shank[i] = line_of_cut_[cut] < 0;
  }
  report_.left = mesh_.volume();
  report_.stock = stock_.statistics();
  if (!setup_.target) return;
  report_.deviation = deviation_from(*setup_.target, mesh_, setup_.floor, progress);
  // The deepest gouge of each line, and the highest rest of all.
  std::map<int, std::size_t> worst;
  std::size_t highest = 0;
  const auto& at = report_.deviation->at_vertex;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] > at[highest]) highest = i;
    if (!(at[i] < -setup_.gouge) || by_shank[i]) continue;  // what the shank did was told of
    const auto [found, fresh] = worst.try_emplace(vertex_lines_[i], i);
    if (!fresh && at[i] < at[found->second]) found->second = i;
  }
  const auto place = [&](std::size_t i) -> Vec3 { return {mesh_.vertices[i][0], mesh_.vertices[i][1], mesh_.vertices[i][2]}; };
  for (const auto& [line, i] : worst) {
    const Vec3 p = place(i);
    report_.events.push_back(
        {Kind::gouge, line, vertex_tools_[i], p, -at[i],
         line ? fmt::format("it cuts {:.3f} mm into the target at ({:.3f}, {:.3f}, {:.3f})", -at[i], p.x(), p.y(), p.z())
              : fmt::format("the stock lacks {:.3f} mm of the target at ({:.3f}, {:.3f}, {:.3f})", -at[i], p.x(), p.y(), p.z())});
  }
  if (setup_.excess > 0 && !at.empty() && at[highest] > setup_.excess) {
    const Vec3 p = place(highest);
    report_.events.push_back(
        {Kind::excess, vertex_lines_[highest], vertex_tools_[highest], p, at[highest],
         fmt::format("{:.3f} mm are left over the target at ({:.3f}, {:.3f}, {:.3f})", at[highest], p.x(), p.y(), p.z())});
  }
}

}  // namespace fieldfab::cam
