/// CT volumes into layers: for the filter, and for opening files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "filter.h"

namespace fieldfab::meshlab {

/// *.raw, *.vol ...
std::vector<std::string> volume_patterns();
std::string volume_patterns_text();

/// What is asked: the threshold, which side of it, noise, pieces, voxel.
std::vector<Parameter> volume_parameters();

/// Reads a volume by what was chosen. A slice of a stack stands for the folder it lies in. Throws io, bad_input, too_large,
/// cancelled.
Layer import_volume(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log, Progress& progress);

}  // namespace fieldfab::meshlab
