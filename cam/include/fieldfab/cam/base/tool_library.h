/// Tool libraries of other programs: FreeCAD's Path workbench (.fctb, a tool; .fctl, a library) and
/// Fusion (.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"

namespace fieldfab::cam {

/// Reads the numbered tools of a library; a .fctb file has one tool with number 1. Libraries may
/// contain kinds that Tool cannot represent (probes, saws, thread mills); these are omitted. Throws
/// Error(bad_input) with the file, Error(io).
std::vector<Tool> read_tool_library(const std::filesystem::path& path);

}  // namespace fieldfab::cam
