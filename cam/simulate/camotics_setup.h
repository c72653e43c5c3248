/// Projects of CAMotics as set-ups.
#pragma once

#include "fieldfab/cam/simulate/setup.h"

namespace fieldfab::cam {

/// Reads a .camotics file (JSON): its tools, its workpiece, its units (of programs that name none) and its resolution. The
/// programs it names are not opened, but for the size of a workpiece that is left to the paths. Throws bad_input, io, cancelled.
SimulationSetup read_camotics(const std::filesystem::path& path, Progress& progress);

}  // namespace fieldfab::cam
