#include "fieldfab/cam/simulate/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/mapped_file.h"
#include "fieldfab/field/certainty.h"
#include "simulation_run.h"
#include "stock/closed_mesh.h"

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
  options.dialect = setup_.machine.dialect;
  options.inch = setup_.inch;
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

void Simulation::note_thin_parts(Progress& progress) {
  const double cell = stock_.lattice().spacing().minCoeff();
  const Certainty thin = certainty_of_cells(*setup_.target, setup_.stock_box, cell, progress);
  if (thin.places.empty() || thin.doubt == Doubt::slopes_unknown) return;
  const Vec3 p = thin.places.front().box.centre();
  report_.notes.push_back(
      {0, fmt::format(
              "the target may have parts thinner than a cell of {:.3g} mm at {} places, the largest {:.3g} mm, about ({:.3f}, "
              "{:.3f}, {:.3f}): cuts into them may not be seen",
              cell, thin.count, thin.largest, p.x(), p.y(), p.z())});
}

void Simulation::finish(Progress& progress) {
  std::optional<DeviationGauge> gauge;
  if (setup_.target) gauge.emplace(*setup_.target, setup_.floor, setup_.gouge, line_of_cut_, 0.5 * stock_.tolerance());
  ClosedMesh closed = closed_mesh(stock_, gauge ? &*gauge : nullptr, progress);
  mesh_ = std::move(closed.mesh);
  vertex_lines_.clear(), vertex_tools_.clear();
  for (const std::uint32_t cut : closed.cuts) vertex_lines_.push_back(line_of(cut)), vertex_tools_.push_back(tool_of(cut));
  report_.left = mesh_.volume();
  report_.stock = stock_.statistics();
  if (!gauge) return;
  report_.deviation = gauge->result();
  report_.deviation->at_vertex = std::move(closed.deviations);
  const auto add = [&](Kind kind, const DeviationGauge::Spot& spot, const auto& message) {
    const Vec3 p(spot.place[0], spot.place[1], spot.place[2]);
    const double amount = std::abs(spot.deviation);
    report_.events.push_back(
        {kind, line_of(spot.cut), tool_of(spot.cut), p, amount, fmt::format(fmt::runtime(message), amount, p.x(), p.y(), p.z())});
  };
  for (const auto& [line, spot] : gauge->gouges())
    add(Kind::gouge, spot,
        line ? "it cuts {:.3f} mm into the target at ({:.3f}, {:.3f}, {:.3f})"
             : "the stock lacks {:.3f} mm of the target at ({:.3f}, {:.3f}, {:.3f})");
  note_thin_parts(progress);
  const DeviationGauge::Spot highest = gauge->highest();
  if (setup_.excess > 0 && highest.deviation > setup_.excess)
    add(Kind::excess, highest, "{:.3f} mm are left over the target at ({:.3f}, {:.3f}, {:.3f})");
}

}  // namespace fieldfab::cam
