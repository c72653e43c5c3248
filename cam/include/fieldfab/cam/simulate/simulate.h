/// Simulation of programs: material removal and collision detection (docs/simulation.md).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/cam/simulate/report.h"
#include "fieldfab/cam/simulate/setup.h"
#include "fieldfab/cam/stock/cuts.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::cam {

struct SimulationOptions {
  bool remember = false;                 ///< whether to record the moves for Playback
  StockEdges edges = StockEdges::sharp;  ///< of the remaining stock's mesh
};

/// The surface of the remaining stock, as Stock::mesh() returns it. With a target, vertices of a flat area are merged
/// only if their deviations are similar: within a hundredth of a cell, or, for excess material, within half of the
/// excess.
struct LeftSurface {
  TriangleMesh mesh;
  std::vector<std::uint32_t> cuts;  ///< number of the cut that made each vertex
};

/// Result of a simulation. It is immutable; copies share their data.
class SimulationResult {
 public:
  struct Parts {
    SimulationSetup setup;
    Stock stock;  ///< the remaining stock
    Cuts cuts;    ///< cuts referenced by its samples
    LeftSurface surface;
    std::shared_ptr<const Playback> playback;  ///< null unless SimulationOptions::remember was set
    SimulationReport report;
  };
  explicit SimulationResult(Parts parts) : parts_(std::make_shared<const Parts>(std::move(parts))) {}

  [[nodiscard]] const SimulationSetup& setup() const { return parts_->setup; }
  [[nodiscard]] const Stock& stock() const { return parts_->stock; }
  [[nodiscard]] const Cuts& cuts() const { return parts_->cuts; }
  [[nodiscard]] const LeftSurface& surface() const { return parts_->surface; }
  [[nodiscard]] const std::shared_ptr<const Playback>& playback() const { return parts_->playback; }
  [[nodiscard]] const SimulationReport& report() const { return parts_->report; }
  [[nodiscard]] const std::vector<SimulationEvent>& events() const { return parts_->report.events; }
  /// Returns, per vertex of the surface, the program line and the tool that made it; 0 for the initial surface.
  [[nodiscard]] std::vector<int> lines_of_vertices() const;
  [[nodiscard]] std::vector<int> tools_of_vertices() const;

 private:
  std::shared_ptr<const Parts> parts_;
};

/// Executes program files in sequence on the set-up's stock, and compares the result with the target, if any. Accepts
/// G-code, .sbp, .rml and .hpgl, selected by the set-up's machine or the file's extension. An empty list selects the
/// programs named by the set-up. Throws Error(bad_input) with FILE:LINE, Error(io), Error(cancelled).
SimulationResult simulate(SimulationSetup setup, std::vector<std::filesystem::path> programs,
                          const SimulationOptions& options = {}, Progress& progress = Progress::none());
/// Executes one program file; see above.
inline SimulationResult simulate(SimulationSetup setup, const std::filesystem::path& program,
                                 const SimulationOptions& options = {}, Progress& progress = Progress::none()) {
  return simulate(std::move(setup), std::vector{program}, options, progress);
}

}  // namespace fieldfab::cam
