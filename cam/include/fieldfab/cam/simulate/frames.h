/// A simulation as a series of pictures, for videos.
#pragma once

#include <filesystem>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

struct FrameSettings {
  int count = 100;      ///< of pictures, at even times on the machine; the last one at the program's end
  int size = 800;       ///< pixels along a picture's longer side
  double alpha = 0.5;   ///< turn about z, radians
  double beta = -0.95;  ///< then tilt about x, radians
};

/// The surface of a whole tool, closed piece by piece; circles have `parts` sides.
TriangleMesh tool_mesh(const ToolSolid& tool, ToolRole role, const ToolPose& pose, int parts = 48);

/// Writes frame_0001.png and so on into a folder, which is made where it is missing: the stock as it is at that time, coloured by
/// tools, and the tool where it is. All show the same part of space. The simulation has to
/// remember. Throws bad_input for
/// settings out of range or where nothing moved, io, cancelled.
void write_frames(const SimulationResult& result, const std::filesystem::path& folder, const FrameSettings& settings = {},
                  Progress& progress = Progress::none());

}  // namespace fieldfab::cam
