#include "fieldfab/cam/simulate/simulate.h"

#include <fmt/format.h>

#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/field/certainty.h"
#include "simulation_run.h"
#include "stock/closed_mesh.h"

namespace fieldfab::cam {

SimulationSetup::SimulationSetup() { limits.fill({-1e300, 1e300}); }

namespace {

/// Adds a note if the target may have parts thinner than the stock's cells.
void note_thin_parts(const SimulationSetup& setup, const Stock& stock, EventLog& log, Progress& progress) {
  const double cell = stock.lattice().spacing().minCoeff();
  const Certainty thin = certainty_of_cells(*setup.target, setup.stock_box, cell, progress);
  if (thin.places.empty() || thin.doubt == Doubt::slopes_unknown) return;
  const Vec3 p = thin.places.front().box.centre();
  log.note(
      {0, fmt::format(
              "the target may have parts thinner than a cell of {:.3g} mm at {} places, the largest {:.3g} mm, about "
              "({:.3f}, {:.3f}, {:.3f}): cuts into them may not be seen",
              cell, thin.count, thin.largest, p.x(), p.y(), p.z())});
}

/// Logs the places where the surface deviates from the target by more than the tolerance.
void log_deviations(const SimulationSetup& setup, const DeviationGauge& gauge, const Cuts& cuts, EventLog& log) {
  const auto event = [&](SimulationEvent::Kind kind, const DeviationGauge::Spot& spot, const auto& message) {
    const Vec3 p(spot.place[0], spot.place[1], spot.place[2]);
    const double amount = std::abs(spot.deviation);
    return SimulationEvent{kind, cuts[spot.cut].move, p, amount,
                           fmt::format(fmt::runtime(message), amount, p.x(), p.y(), p.z())};
  };
  for (const auto& [pass, gouge] : gauge.gouges()) {
    SimulationEvent made = event(SimulationEvent::Kind::gouge, gouge.deepest,
                                 pass ? "it cuts {:.3f} mm into the target at ({:.3f}, {:.3f}, {:.3f})"
                                      : "the stock lacks {:.3f} mm of the target at ({:.3f}, {:.3f}, {:.3f})");
    made.first_line = gouge.first_line, made.last_line = gouge.last_line;
    log.add(std::move(made));
  }
  const DeviationGauge::Spot highest = gauge.highest();
  if (setup.excess > 0 && highest.deviation > setup.excess)
    log.add(event(SimulationEvent::Kind::excess, highest,
                  "{:.3f} mm are left over the target at ({:.3f}, {:.3f}, {:.3f})"));
}

}  // namespace

std::vector<int> SimulationResult::lines_of_vertices() const {
  std::vector<int> lines;
  lines.reserve(surface().cuts.size());
  for (const std::uint32_t cut : surface().cuts) lines.push_back(cuts()[cut].move.line);
  return lines;
}

std::vector<int> SimulationResult::tools_of_vertices() const {
  std::vector<int> tools;
  tools.reserve(surface().cuts.size());
  for (const std::uint32_t cut : surface().cuts) tools.push_back(cuts()[cut].move.tool);
  return tools;
}

SimulationResult simulate(SimulationSetup setup, std::vector<std::filesystem::path> programs,
                          const SimulationOptions& options, Progress& progress) {
  if (programs.empty()) programs = setup.programs;
  if (programs.empty())
    throw Error(ErrorKind::bad_input, setup.file, "neither this set-up nor the call names a program");
  SimulationRun run(setup, options, progress);
  for (const std::filesystem::path& program : programs) run.carry_out(ProgramFile(program));
  const Stock& stock = run.stock();
  std::optional<DeviationGauge> gauge;
  if (setup.target) gauge.emplace(*setup.target, setup.floor, setup.gouge, run.cuts(), 0.5 * stock.tolerance());
  ClosedMesh closed = closed_mesh(stock, options.edges, gauge ? &*gauge : nullptr, progress);
  const StockStatistics statistics = stock.statistics();
  std::optional<Deviation> deviation;
  if (gauge) {
    log_deviations(setup, *gauge, run.cuts(), run.log());
    note_thin_parts(setup, stock, run.log(), progress);
    deviation = gauge->result();
    deviation->at_vertex = std::move(closed.deviations);
  }
  SimulationResult::Parts parts = std::move(run).take();
  parts.report.left = closed.mesh.volume();
  parts.report.stock = statistics;
  parts.report.deviation = std::move(deviation);
  parts.surface = {std::move(closed.mesh), std::move(closed.cuts)};
  parts.setup = std::move(setup);
  return SimulationResult(std::move(parts));
}

}  // namespace fieldfab::cam
