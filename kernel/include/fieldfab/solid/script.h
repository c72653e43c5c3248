/// Models defined by Python scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"

namespace fieldfab {

/// Runs a .py or .ko script in a process of its own (fieldfab.script) and returns its model as .frep text. Throws
/// Error(bad_input) with the script's line and message if it fails or takes more than one minute, Error(cancelled)
/// after cancellation. The process has ended on return in each case.
std::string run_script(const std::filesystem::path& path, Progress& progress);

/// The Python program that the fieldfab module of this build is for.
std::string python_program();

/// Returns this process's environment, changed so that Python imports the fieldfab module of this build. Entries are
/// NAME=VALUE.
std::vector<std::string> python_environment();

}  // namespace fieldfab
