/// Simulation reports for people.
#pragma once

#include <filesystem>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// Writes one HTML file with embedded pictures and charts: the verdict, events with their program lines, figures, the
/// work of each tool, deviations from the target, and ignored words. Quotes lines from the program's file. Throws
/// Error(io), Error(cancelled).
void write_html_report(const SimulationResult& result, const std::filesystem::path& path,
                       Progress& progress = Progress::none());

}  // namespace fieldfab::cam
