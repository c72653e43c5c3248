/// A simulation as a sequence of pictures, for videos.
#pragma once

#include <filesystem>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

struct FrameSettings {
  /// number of pictures, at equal time steps of the machine; the last shows the end of the program
  int count = 100;
  int size = 800;       ///< longer side of a picture, pixels
  double alpha = 0.5;   ///< rotation about z, radians
  double beta = -0.95;  ///< then rotation about x, radians
};

/// Returns the surface of a tool's parts with one role, each piece closed. `parts` is the number of sides of a circle.
TriangleMesh tool_mesh(const ToolSolid& tool, ToolRole role, const ToolPose& pose, int parts = 48);

/// Writes frame_0001.png and so on into a folder, which is created if missing. Each shows the stock at that time,
/// coloured by tool, and the tool. All show the same region. The simulation must have been run with
/// SimulationOptions::remember. Throws Error(bad_input) for settings out of range or without motion, Error(io),
/// Error(cancelled).
void write_frames(const SimulationResult& result, const std::filesystem::path& folder,
                  const FrameSettings& settings = {}, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
