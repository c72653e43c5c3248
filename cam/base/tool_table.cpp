#include "tool_table.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

Tool read_tool(const TomlTable& table, int number) {
  table.only({"number", "name", "shape", "diameter", "corner_radius", "angle", "tip_diameter", "profile", "flute", "length",
              "shank", "holder_diameter", "holder_length", "flutes", "feed", "plunge", "spindle"});
  Tool tool;
  const auto get = [&](const char* key, double& into) {
    if (const auto value = table.number(key)) {
      if (!(*value >= 0) || !std::isfinite(*value))
        throw Error(ErrorKind::bad_input, table.place(key), fmt::format("{} must not be negative", key));
      into = *value;
    }
  };
  tool.number = static_cast<int>(table.number("number").value_or(number));
  tool.name = table.text("name").value_or("");
  tool.shape = tool_shape_named(table.text("shape").value_or("flat"), table.place("shape"));
  get("diameter", tool.diameter), get("corner_radius", tool.corner_radius), get("angle", tool.angle),
      get("tip_diameter", tool.tip_diameter);
  get("flute", tool.flute), get("length", tool.length), get("shank", tool.shank), get("holder_diameter", tool.holder_diameter);
  get("holder_length", tool.holder_length), get("feed", tool.feed), get("plunge", tool.plunge), get("spindle", tool.spindle);
  tool.angle *= std::numbers::pi / 180;
  tool.flutes = static_cast<int>(table.number("flutes").value_or(2));
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

std::vector<Tool> read_tools(const TomlTable& file) {
  std::vector<Tool> tools;
  int next = 1;
  for (const TomlTable& table : file.tables("tool")) {
    Tool tool = read_tool(table, next);
    next = tool.number + 1;
    for (const Tool& other : tools)
      if (other.number == tool.number)
        throw Error(ErrorKind::bad_input, table.place("number"), fmt::format("there are two tools with number {}", tool.number));
    tools.push_back(std::move(tool));
  }
  return tools;
}

}  // namespace fieldfab::cam
