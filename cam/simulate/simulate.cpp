#include "fieldfab/cam/simulate/simulate.h"

#include <fmt/format.h>

#include <cmath>

#include "fieldfab/field/certainty.h"
#include "simulation_run.h"
#include "stock/closed_mesh.h"

namespace fieldfab::cam {

SimulationSetup::SimulationSetup() { limits.fill({-1e300, 1e300}); }

namespace {

/// Tells where the target may have parts that the stock's cells are too large for.
void note_thin_parts(const SimulationSetup& setup, const Stock& stock, EventLog& log, Progress& progress) {
  const double cell = stock.lattice().spacing().minCoeff();
  const Certainty thin = certainty_of_cells(*setup.target, setup.stock_box, cell, progress);
  if (thin.places.empty() || thin.doubt == Doubt::slopes_unknown) return;
  const Vec3 p = thin.places.front().box.centre();
  log.note(0, fmt::format("the target may have parts thinner than a cell of {:.3g} mm at {} places, the largest {:.3g} mm, about "
                          "({:.3f}, {:.3f}, {:.3f}): cuts into them may not be seen",
                          cell, thin.count, thin.largest, p.x(), p.y(), p.z()));
}

/// Tells where the surface is off the target by more than is allowed.
void log_deviations(const SimulationSetup& setup, const DeviationGauge& gauge, const Cuts& cuts, EventLog& log) {
  const auto add = [&](SimulationEvent::Kind kind, const DeviationGauge::Spot& spot, const auto& message) {
    const Vec3 p(spot.place[0], spot.place[1], spot.place[2]);
    const double amount = std::abs(spot.deviation);
    const Cut cut = cuts[spot.cut];
    log.add({kind, cut.line, cut.tool, p, amount, fmt::format(fmt::runtime(message), amount, p.x(), p.y(), p.z())});
  };
  for (const auto& [line, spot] : gauge.gouges())
    add(SimulationEvent::Kind::gouge, spot,
        line ? "it cuts {:.3f} mm into the target at ({:.3f}, {:.3f}, {:.3f})"
             : "the stock lacks {:.3f} mm of the target at ({:.3f}, {:.3f}, {:.3f})");
  const DeviationGauge::Spot highest = gauge.highest();
  if (setup.excess > 0 && highest.deviation > setup.excess)
    add(SimulationEvent::Kind::excess, highest, "{:.3f} mm are left over the target at ({:.3f}, {:.3f}, {:.3f})");
}

}  // namespace

std::vector<int> SimulationResult::lines_of_vertices() const {
  std::vector<int> lines;
  lines.reserve(surface().cuts.size());
  for (const std::uint32_t cut : surface().cuts) lines.push_back(cuts()[cut].line);
  return lines;
}

std::vector<int> SimulationResult::tools_of_vertices() const {
  std::vector<int> tools;
  tools.reserve(surface().cuts.size());
  for (const std::uint32_t cut : surface().cuts) tools.push_back(cuts()[cut].tool);
  return tools;
}

SimulationResult simulate(SimulationSetup setup, const std::filesystem::path& program, const SimulationOptions& options,
                          Progress& progress) {
  SimulationRun run(setup, options, progress);
  run.carry_out(ProgramFile(program));
  const Stock& stock = run.stock();
  std::optional<DeviationGauge> gauge;
  if (setup.target) gauge.emplace(*setup.target, setup.floor, setup.gouge, run.cuts(), 0.5 * stock.tolerance());
  ClosedMesh closed = closed_mesh(stock, gauge ? &*gauge : nullptr, progress);
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
  parts.program = program;
  parts.setup = std::move(setup);
  return SimulationResult(std::move(parts));
}

}  // namespace fieldfab::cam
