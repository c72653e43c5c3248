/// Tools in job and set-up files.
#pragma once

#include <filesystem>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "toml_table.h"

namespace fieldfab::cam {

/// Reads a [[tool]] table. Missing keys keep their values of `tool`. Throws Error(bad_input) with
/// FILE:LINE.
Tool read_tool(const TomlTable& table, Tool tool);
/// Reads all [[tool]] tables of a file. `folder`: location of the tool libraries that they name.
/// Throws Error(bad_input), also for two tools with one number, and Error(io).
std::vector<Tool> read_tools(const TomlTable& file, const std::filesystem::path& folder);

}  // namespace fieldfab::cam
