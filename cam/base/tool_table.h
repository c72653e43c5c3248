/// Tools as job and set-up files describe them.
#pragma once

#include "fieldfab/cam/base/tool.h"
#include "toml_table.h"

namespace fieldfab::cam {

/// Reads a [[tool]] table; `number` is its number where it names none. Throws bad_input with FILE:LINE.
Tool read_tool(const TomlTable& table, int number);
/// All [[tool]] tables of a file. Throws bad_input, also for two of one number.
std::vector<Tool> read_tools(const TomlTable& file);

}  // namespace fieldfab::cam
