/// Tools as other programs keep them: FreeCAD's Path workbench (.fctb, a tool; .fctl, a library) and Fusion (.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"

namespace fieldfab::cam {

/// The tools of a library with their numbers; a .fctb has one tool, of number 1. Kinds that no Tool can be (probes, saws, thread
/// mills) are left out of libraries. Throws bad_input with the file, io.
std::vector<Tool> read_tool_library(const std::filesystem::path& path);

}  // namespace fieldfab::cam
