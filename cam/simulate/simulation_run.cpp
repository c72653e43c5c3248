#include "simulation_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

using EventKind = SimulationEvent::Kind;

namespace {

std::string tool_list(const std::map<int, Tool>& tools) {
  std::vector<int> numbers;
  numbers.reserve(tools.size());
  for (const auto& [number, tool] : tools) numbers.push_back(number);
  return numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, ", "));
}

Stock first_stock(const SimulationSetup& setup, Progress& progress) {
  if (!setup.saved)
    return setup.stock ? Stock(*setup.stock, setup.stock_box, setup.sampling, progress)
                       : Stock(setup.stock_box, setup.sampling);
  if (const double cell = setup.saved->settings().cell; setup.sampling.cell != cell)
    throw Error(ErrorKind::bad_input, setup.file,
                fmt::format("the saved stock has a cell of {:.6g} mm, which does not change", cell));
  return *setup.saved;
}

}  // namespace

SimulationRun::SimulationRun(const SimulationSetup& setup, const SimulationOptions& options, Progress& progress)
    : setup_(setup), progress_(progress), stock_(first_stock(setup, progress)) {
  if (setup.fixture) fixture_.emplace(*setup.fixture, setup.fixture_box, setup.sampling, progress);
  if (options.remember) playback_ = std::make_shared<Playback>(stock_);
  placement_ = setup_.placement;
}

void SimulationRun::carry_out(const ProgramFile& program) {
  program_ = &program;
  ++program_number_;
  report_.programs.push_back(program.path());
  poses_.emplace(setup_, program.path().string());
  at_ = setup_.start, offset_ = Vec3::Zero(), known_ = false, height_known_ = setup_.start_given;
  spindle_turns_ = by_hand_ = false;
  ++pass_;
  // A program without tool words uses the only tool, if there is one.
  if (!mounted_ && setup_.tools.size() == 1) mount(setup_.tools.begin()->second);
  const std::vector<ReadingNote> notes = program.read(
      setup_, [this](const Motion& motion) { take_motion(motion); }, progress_);
  flush();
  if (!spindle_turns_)
    if (const int line = log_.forget(EventKind::spindle_stopped, program_number_); line > 0)
      log_.note({line, "the spindle never turns while the program moves: it is taken as switched on by hand",
                 program_number_});
  log_.add_first(notes, program_number_);
}

SimulationResult::Parts SimulationRun::take() && {
  log_.move_to(report_);
  return {{}, std::move(stock_), std::move(cuts_), {}, std::move(playback_), std::move(report_)};
}

void SimulationRun::take_motion(const Motion& motion) {
  ++report_.moves;
  spindle_turns_ = spindle_turns_ || motion.spindle != 0;
  if (motion.tool != tool_number_ && motion.tool != 0 && !by_hand_) change_tool(motion.tool, motion.line);
  switch (motion.kind) {
    case Motion::Kind::rapid:
    case Motion::Kind::feed:
    case Motion::Kind::arc: move(motion); break;
    case Motion::Kind::dwell:
      record(motion.line).seconds += motion.seconds;
      report_.seconds += motion.seconds;
      break;
    case Motion::Kind::stop: stop(motion); break;
    case Motion::Kind::tool_change:
    case Motion::Kind::end: break;
  }
}

void SimulationRun::mount(const Tool& tool) {
  flush();  // strokes refer to the previous tool
  const auto mounted = std::make_shared<Mounted>();
  mounted->tool = tool;
  mounted->solid = tool_solid(tool);
  // Errors of swept surfaces are no contacts.
  mounted->inner = mounted->solid.shrunk(std::max(setup_.touch, 2 * stock_.tolerance()));
  mounted_ = mounted;
  tool_number_ = tool.number;
  known_ = false;  // the motion to the position of the tool change and back is not part of the program
  ++pass_;
}

void SimulationRun::change_tool(int number, int line) {
  const auto found = setup_.tools.find(number);
  if (found == setup_.tools.end())
    throw Error(ErrorKind::bad_input, fmt::format("{}:{}", program_->path().string(), line),
                fmt::format("tool {} is not in the set-up, which has {}", number, tool_list(setup_.tools)));
  mount(found->second);
}

void SimulationRun::stop(const Motion& motion) {
  if (stops_ >= setup_.stops.size()) return;
  const StopAction& action = setup_.stops[stops_++];
  if (action.placement) {
    flush();
    placement_ = *action.placement;
    known_ = false;  // the part was turned over: the motion to this position is unknown
  }
  if (action.tool) change_tool(action.tool, motion.line), by_hand_ = true;
}

/// Mounts the initial tool of a program that names none.
void SimulationRun::need_tool(const Motion& motion) {
  if (setup_.tools.empty())
    throw Error(ErrorKind::bad_input, fmt::format("{}:{}", program_->path().string(), motion.line),
                "no tool is in the spindle; the set-up has none");
  const auto first = setup_.tools.find(setup_.first_tool);
  const Tool& tool = (first != setup_.tools.end() ? first : setup_.tools.begin())->second;
  log_.note({motion.line, fmt::format("the program names no tool: number {} is taken", tool.number), program_number_});
  mount(tool);
}

void SimulationRun::move(const Motion& motion) {
  poses_->check(motion);
  const bool rapid = motion.kind == Motion::Kind::rapid;
  if (!mounted_ && setup_.first_tool == 0 && rapid) {
    at_ = motion.end;  // an empty spindle
    return;
  }
  if (!mounted_) need_tool(motion);
  if (rapid != pass_is_rapid_) ++pass_;
  pass_is_rapid_ = rapid;
  const double risen = motion.end.at[2] + motion.tool_offset.z() - at_.at[2] - offset_.z();
  height_known_ = height_known_ || !rapid || std::abs(risen) > 1e-9;
  const Tool& tool = mounted_->tool;
  const double tolerance = stock_.tolerance();
  // The axes stay where they were, even if the control assumes another length of tool.
  AxisValues start = known_ ? at_ : motion.end;
  for (std::size_t a = 0; known_ && a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    start.at[a] += offset_[i] - motion.tool_offset[i];
  }
  const std::vector<AxisValues> stations = poses_->places(start, motion, tolerance);
  check_limits(motion, stations);
  const double lengthened = motion.tool_offset != Vec3::Zero() ? motion.tool_offset.z() - tool.length : 0;
  std::vector<ToolPose> way =
      poses_->along(stations, motion.mode, lengthened, tool.length, placement_, mounted_->solid.length(), tolerance);
  if (!known_) way.erase(way.begin(), way.end() - 1);
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i].tip - way[i - 1].tip).norm();
  const double seconds = duration_of(motion, length);
  record(motion.line).seconds += seconds;
  report_.seconds += seconds;
  if (rapid) report_.rapid_seconds += seconds, report_.rapid += length;
  const std::uint32_t tip = cuts_.add(cut_move(motion));
  if (way.size() == 1 && !known_ && height_known_) add(way[0], way[0], motion, tip, 0);
  for (std::size_t i = 1; i < way.size(); ++i)
    add(way[i - 1], way[i], motion, tip, (way[i].tip - way[i - 1].tip).norm());
  if (playback_) {
    AxisValues axes = motion.end;  // x, y, z from the part's zero, as a machine's display shows them
    for (std::size_t a = 0; a < 3; ++a) axes.at[a] -= setup_.zero[static_cast<Eigen::Index>(a)];
    playback_->add({motion.line, tool.number, rapid, report_.seconds, axes, program_number_},
                   {mounted_, &mounted_->solid}, tip, way);
  }
  report_.poses += way.size() - 1;
  at_ = motion.end;
  offset_ = motion.tool_offset;
  known_ = height_known_;
  if (strokes_.size() >= 4096) {
    flush();
    progress_.report(std::min(1.0, static_cast<double>(motion.line) / program_->lines()),
                     fmt::format("line {}", motion.line));
    progress_.check();
  }
}

void SimulationRun::add(const ToolPose& from, const ToolPose& to, const Motion& motion, std::uint32_t tip,
                        double length) {
  const bool rapid = motion.kind == Motion::Kind::rapid;
  Purpose purpose{Purpose::What::cut, record_, cut_move(motion), length, motion.spindle == 0};
  const auto stroke = [&](const ToolSolid& tool, ToolRole role, Purpose::What what, bool removes) {
    purpose.what = what;
    add_strokes(tool, role, from, to, tip, removes, strokes_);
    // the length of the motion counts once
    for (; purposes_.size() < strokes_.size(); purpose.length = 0) purposes_.push_back(purpose);
  };
  const ToolSolid &solid = mounted_->solid, &inner = mounted_->inner;
  // First the inner solid, for rapids; then the cut; then the parts that must not touch the
  // remaining material.
  if (rapid) stroke(inner, ToolRole::cutting, Purpose::What::rapid, false), purpose.length = length;
  stroke(solid, ToolRole::cutting, rapid ? Purpose::What::rapid : Purpose::What::cut, true);
  stroke(inner, ToolRole::shank, Purpose::What::shank, false);
  stroke(inner, ToolRole::holder, Purpose::What::holder, false);
  // A shank whose contact is reported also removes the material, so that it is reported once.
  stroke(solid, ToolRole::shank, Purpose::What::shank, true);
  if (!fixture_) return;
  purpose.what = Purpose::What::fixture;
  for (const ToolRole role : {ToolRole::cutting, ToolRole::shank, ToolRole::holder})
    add_strokes(inner, role, from, to, tip, false, fixture_strokes_);
  fixture_purposes_.resize(fixture_strokes_.size(), purpose);
}

/// Executes the collected strokes.
void SimulationRun::flush() {
  if (strokes_.empty()) return;
  const std::vector<StrokeResult> results = stock_.cut(strokes_, progress_);
  for (std::size_t i = 0; i < results.size(); ++i) judge(strokes_[i], purposes_[i], results[i]);
  strokes_.clear();
  purposes_.clear();
  if (playback_) playback_->keep(stock_);
  if (fixture_strokes_.empty()) return;
  const std::vector<StrokeResult> touched = fixture_->cut(fixture_strokes_, progress_);
  for (std::size_t i = 0; i < touched.size(); ++i) judge(fixture_strokes_[i], fixture_purposes_[i], touched[i]);
  fixture_strokes_.clear();
  fixture_purposes_.clear();
}

void SimulationRun::judge(const Stroke& stroke, const Purpose& purpose, const StrokeResult& result) {
  const auto told = [&](EventKind kind, const char* what) {
    if (result.volume <= 0) return;
    log_.add({kind, purpose.move, result.place, result.volume,
              fmt::format("{}: {:.3g} mm3 at ({:.3f}, {:.3f}, {:.3f})", what, result.volume, result.place.x(),
                          result.place.y(), result.place.z())});
  };
  LineRecord& line = report_.lines[purpose.record];
  switch (purpose.what) {
    case Purpose::What::cut:
      line.removed += result.volume, report_.removed += result.volume;
      // Rubbing along a surface counts as air: a chip of less than 0.01 mm by 0.01 mm.
      (result.volume > 1e-4 * purpose.length ? line.cut : line.air) += purpose.length;
      (result.volume > 1e-4 * purpose.length ? report_.cut : report_.air) += purpose.length;
      if (purpose.stopped) told(EventKind::spindle_stopped, "it cuts while the spindle stands");
      break;
    case Purpose::What::rapid:
      if (stroke.removes)
        line.removed += result.volume, report_.removed += result.volume;
      else
        told(EventKind::rapid_contact, "a rapid goes through material");
      break;
    case Purpose::What::shank:
      if (!stroke.removes) told(EventKind::shank_contact, "the shank meets material");
      break;
    case Purpose::What::holder: told(EventKind::holder_contact, "the holder meets material"); break;
    case Purpose::What::fixture: told(EventKind::fixture_contact, "the tool meets a fixture"); break;
  }
}

/// Checks the positions of a motion: an arc may leave the limits between its ends. A motion back
/// from beyond a limit is no further event.
void SimulationRun::check_limits(const Motion& motion, const std::vector<AxisValues>& stations) {
  for (std::size_t axis = 0; axis < 9; ++axis) {
    const auto& [low, high] = setup_.limits[axis];
    const auto beyond = [&](const AxisValues& place) { return std::max(low - place.at[axis], place.at[axis] - high); };
    const double before = beyond(stations.front());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const double excess = beyond(stations[i]);
      const bool end = i + 1 == stations.size();
      if (excess <= 1e-6 || (!end && excess <= before)) continue;
      const double unit = is_rotary(axis) ? degrees_per_radian : 1;
      log_.add({EventKind::over_travel, cut_move(motion), stations[i].xyz() - setup_.zero, excess * unit,
                fmt::format("{} goes to {:.6g}, beyond its limits {:.6g} to {:.6g}", "XYZABCUVW"[axis],
                            stations[i].at[axis] * unit, low * unit, high * unit)});
    }
  }
}

/// Duration of a motion whose tip moves `length` mm relative to the part.
double SimulationRun::duration_of(const Motion& motion, double length) const {
  if (motion.seconds > 0) return motion.seconds;
  double linear = 0, turned = 0;
  for (std::size_t a = 0; a < 3; ++a) linear += std::pow(motion.end.at[a] - at_.at[a], 2);
  for (std::size_t a = 3; a < 6; ++a) turned = std::max(turned, std::abs(motion.end.at[a] - at_.at[a]));
  linear = motion.kind == Motion::Kind::arc ? length : std::sqrt(linear);
  if (!known_) return 0;
  if (motion.kind == Motion::Kind::rapid) {
    constexpr double turning = to_radians(3600);  // radians/min, if no speed is given
    return 60 * std::max(linear / std::max(setup_.machine.dynamics.rapid, 1.0), turned / turning);
  }
  if (motion.feed <= 0) return 0;
  return 60 * (linear > 1e-9 ? linear : turned) / motion.feed;
}

LineRecord& SimulationRun::record(int line) {
  auto& lines = report_.lines;
  record_ = lines.size() - 1;
  if (lines.empty() || lines.back().line != line || lines.back().tool != tool_number_ ||
      lines.back().program != program_number_) {
    const auto [at, fresh] = record_of_line_.try_emplace({program_number_, line, tool_number_}, lines.size());
    if (fresh) lines.push_back({line, tool_number_, 0, 0, 0, 0, program_number_});
    record_ = at->second;
  }
  return lines[record_];
}

}  // namespace fieldfab::cam
