/// Import of CT volumes as layers, for the filter and for opening files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "filter.h"

namespace fieldfab::meshlab {

/// *.raw, *.vol ...
std::vector<std::string> volume_patterns();
std::string volume_patterns_text();

/// Parameters: the threshold, its side, noise, pieces, voxel.
std::vector<Parameter> volume_parameters();

/// Reads a volume with the chosen parameters. A slice of a stack stands for its folder. Throws io,
/// bad_input, too_large, cancelled.
Layer import_volume(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log,
                    Progress& progress);

}  // namespace fieldfab::meshlab
