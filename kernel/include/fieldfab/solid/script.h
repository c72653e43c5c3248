/// Models that are Python scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"

namespace fieldfab {

/// Runs a script, .py or .ko, in a process of its own (fieldfab.script) and returns what it makes as .frep text. Throws bad_input with the script's
/// line and message where it fails or runs for more than a minute, cancelled when told so; either way the process is gone
/// afterwards.
std::string run_script(const std::filesystem::path& path, Progress& progress);

/// This process's environment, changed so that Python finds the module fieldfab that belongs to this very build.
std::vector<std::string> python_environment();

}  // namespace fieldfab
