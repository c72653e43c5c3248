#include "tool_table.h"

#include <fmt/format.h>

#include <cmath>

#include "fieldfab/cam/base/tool_library.h"
#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

Tool read_tool(const TomlTable& table, Tool tool) {
  table.only({"library", "number", "name", "shape", "diameter", "corner_radius", "angle", "tip_diameter", "profile",
              "flute", "length", "shank", "holder_diameter", "holder_length", "flutes", "feed", "plunge", "spindle"});
  const auto get = [&](const char* key, double& into) {
    if (const auto value = table.number(key)) {
      if (!(*value >= 0) || !std::isfinite(*value))
        throw Error(ErrorKind::bad_input, table.place(key), fmt::format("{} must not be negative", key));
      into = *value;
    }
  };
  tool.number = static_cast<int>(table.number("number").value_or(tool.number));
  tool.name = table.text("name").value_or(tool.name);
  if (const auto shape = table.text("shape")) tool.shape = tool_shape_named(*shape, table.place("shape"));
  get("diameter", tool.diameter), get("corner_radius", tool.corner_radius), get("tip_diameter", tool.tip_diameter);
  if (double angle = 0; table.has("angle")) get("angle", angle), tool.angle = to_radians(angle);
  get("flute", tool.flute), get("length", tool.length), get("shank", tool.shank),
      get("holder_diameter", tool.holder_diameter);
  get("holder_length", tool.holder_length), get("feed", tool.feed), get("plunge", tool.plunge),
      get("spindle", tool.spindle);
  tool.flutes = static_cast<int>(table.number("flutes").value_or(tool.flutes));
  for (const auto& row : table.rows("profile")) {
    if (row.size() != 2)
      throw Error(ErrorKind::bad_input, table.place("profile"), "a profile is [[distance from the axis, height], ...]");
    tool.points.emplace_back(row[0], row[1]);
  }
  try {
    if (tool.shape == ToolShape::profile && tool.diameter == 0 && !tool.points.empty())
      tool.diameter = 2 * tool.points.back().x();
    if (tool.shape == ToolShape::form) {
      for (const Vec2& point : tool.points) tool.diameter = std::max(tool.diameter, 2 * point.x());
      (void)tool_solid(tool);
    } else if (tool.diameter > 0 || tool.shape == ToolShape::profile)
      (void)tool.profile();
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_input, table.place(), error.what());
  }
  if (tool.name.empty()) tool.name = fmt::format("{:.4g} mm {}", tool.diameter, name_of(tool.shape));
  return tool;
}

namespace {

/// Tools of a library that a table names: all of them, or the one with the given number, with the
/// table's settings applied to it.
std::vector<Tool> tools_of_library(const TomlTable& table, const std::filesystem::path& path, int next) {
  std::vector<Tool> tools = read_tool_library(path);
  const auto number = table.number("number");
  if (path.extension() == ".fctb") {
    tools.front().number = next;
  } else if (number) {
    std::erase_if(tools, [&](const Tool& tool) { return tool.number != *number; });
    if (tools.empty())
      throw Error(ErrorKind::bad_input, table.place("number"),
                  fmt::format("{} has no tool {:g}", path.string(), *number));
  } else {
    table.only({"library"});
    return tools;
  }
  return {read_tool(table, tools.front())};
}

}  // namespace

std::vector<Tool> read_tools(const TomlTable& file, const std::filesystem::path& folder) {
  std::vector<Tool> tools;
  for (const TomlTable& table : file.tables("tool")) {
    Tool fresh;
    fresh.number = tools.empty() ? 1 : tools.back().number + 1;
    const auto library = table.text("library");
    const std::vector<Tool> read =
        library ? tools_of_library(table, folder / *library, fresh.number) : std::vector<Tool>{read_tool(table, fresh)};
    for (const Tool& tool : read) {
      for (const Tool& other : tools)
        if (other.number == tool.number)
          throw Error(ErrorKind::bad_input, table.place("number"),
                      fmt::format("there are two tools with number {}", tool.number));
      tools.push_back(tool);
    }
  }
  return tools;
}

}  // namespace fieldfab::cam
