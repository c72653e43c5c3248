/// The report on a simulation, for people.
#pragma once

#include <filesystem>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// One HTML file, pictures and charts within it: whether the program is good, what is wrong and at which of its lines, figures,
/// what each tool did, deviations from the target, what was passed over. Lines are quoted from the program's file. Throws io,
/// cancelled.
void write_html_report(const SimulationResult& result, const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
