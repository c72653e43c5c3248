/// Projects of CAMotics as simulation set-ups.
#pragma once

#include "fieldfab/cam/simulate/setup.h"

namespace fieldfab::cam {

/// Reads a .camotics file (JSON): its tools, workpiece, units (for programs without a unit) and
/// resolution. Opens the programs only if the size of the workpiece is derived from their paths.
/// Throws Error(bad_input), Error(io), Error(cancelled).
SimulationSetup read_camotics(const std::filesystem::path& path, Progress& progress);

}  // namespace fieldfab::cam
