/// Tools as job and set-up files describe them.
#pragma once

#include <filesystem>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "toml_table.h"

namespace fieldfab::cam {

/// Reads a [[tool]] table; what it does not say is as in `tool`. Throws bad_input with FILE:LINE.
Tool read_tool(const TomlTable& table, Tool tool);
/// All [[tool]] tables of a file; `folder`: where the tool libraries that they name are. Throws bad_input, also for two of one
/// number, io.
std::vector<Tool> read_tools(const TomlTable& file, const std::filesystem::path& folder);

}  // namespace fieldfab::cam
