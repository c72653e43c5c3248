/// Simulating a program on a stock: what it leaves, and what goes wrong on the way (docs/simulation.md).
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
  bool remember = false;  ///< what was done, so that any moment of it can be shown again
};

/// What is left of a stock, as Stock::mesh() has it. Where there is a target, a flat's vertices are merged only where their
/// deviations are alike: within a hundredth of a cell, or, where material is left over, within half of what is.
struct LeftSurface {
  TriangleMesh mesh;
  std::vector<std::uint32_t> cuts;  ///< the number of the cut that made each vertex
};

/// What came of a simulation. It does not change, and copies share everything.
class SimulationResult {
 public:
  struct Parts {
    SimulationSetup setup;
    Stock stock;  ///< what is left
    Cuts cuts;    ///< that its samples remember
    LeftSurface surface;
    std::shared_ptr<const Playback> playback;  ///< null where nothing was remembered
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
  /// The program's line that made each vertex of the surface, and the tool that did; 0 where it is the stock's first surface.
  [[nodiscard]] std::vector<int> lines_of_vertices() const;
  [[nodiscard]] std::vector<int> tools_of_vertices() const;

 private:
  std::shared_ptr<const Parts> parts_;
};

/// Carries out program files one after the other on a set-up's stock and compares what is left with the target, where there is
/// one: G-code, .sbp, .rml or .hpgl, by the set-up's machine or the file's extension. Without programs those that the set-up
/// names. Throws bad_input with FILE:LINE, io, cancelled.
SimulationResult simulate(SimulationSetup setup, std::vector<std::filesystem::path> programs,
                          const SimulationOptions& options = {}, Progress& progress = Progress::none());
inline SimulationResult simulate(SimulationSetup setup, const std::filesystem::path& program,
                                 const SimulationOptions& options = {}, Progress& progress = Progress::none()) {
  return simulate(std::move(setup), std::vector{program}, options, progress);
}

}  // namespace fieldfab::cam
