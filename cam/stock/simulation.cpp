#include "fieldfab/cam/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/mapped_file.h"
#include "simulation_run.h"

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
  else if (extension == ".plt" || extension == ".hpgl" || extension == ".camm" || extension == ".epi" || extension == ".gcc")
    notes =
        read_hpgl(text, name, options, machine.tick > 0 ? machine.tick : 0.025, setup_.pen_up, setup_.pen_down, sink, progress);
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
