#include "fieldfab/cam/base/tool_library.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

using Json = nlohmann::json;

/// A JSON file, and errors in it.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& path)
      : path_(path), root_(Json::parse(read_file(path, 64 << 20), nullptr, false)) {
    if (!root_.is_object()) throw refuse("is no tool library: a JSON object is wanted");
  }
  [[nodiscard]] Error refuse(const std::string& what) const { return {ErrorKind::bad_input, path_.string(), what}; }
  [[nodiscard]] const Json& root() const { return root_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// A value of a table; null if missing.
  static const Json& get(const Json& table, const char* key) {
    static const Json missing;
    const auto found = table.is_object() ? table.find(key) : table.end();
    return table.is_object() && found != table.end() ? *found : missing;
  }
  static std::string text(const Json& table, const char* key) {
    const Json& value = get(table, key);
    return value.is_string() ? value.get<std::string>() : "";
  }
  [[nodiscard]] double number(const Json& table, const char* key) const {
    const Json& value = get(table, key);
    if (value.is_null()) return 0;
    if (!value.is_number() || !std::isfinite(value.get<double>())) throw refuse(fmt::format("'{}' is no number", key));
    return value.get<double>();
  }
  /// Number of a tool.
  [[nodiscard]] int whole(const Json& table, const char* key) const {
    const double value = number(table, key);
    if (!(value >= 0 && value <= 99999) || value != std::floor(value))
      throw refuse(fmt::format("'{}' is no whole number from 0 to 99999", key));
    return static_cast<int>(value);
  }

 private:
  std::filesystem::path path_;
  Json root_;
};

/// Validates a tool.
Tool checked(const JsonFile& file, Tool tool) {
  try {
    (void)tool.profile();
  } catch (const Error& error) {
    throw file.refuse(fmt::format("{}: {}", tool.name, error.what()));
  }
  return tool;
}

/// FreeCAD's quantities: "5.0000 mm", "1/4 in", "60.0000 °"; returns mm or radians.
double quantity(const JsonFile& file, const Json& table, const char* key) {
  const Json& value = JsonFile::get(table, key);
  if (value.is_null()) return 0;
  if (value.is_number()) return file.number(table, key);
  const std::string text = value.is_string() ? value.get<std::string>() : "";
  const auto wrong = [&] {
    return file.refuse(fmt::format("{} is '{:.40}': a number with a unit is wanted", key, text));
  };
  const char *at = text.data(), *const end = text.data() + text.size();
  const auto take = [&] {
    double number = 0;
    const auto [rest, failed] = std::from_chars(at, end, number);
    if (failed != std::errc{} || !std::isfinite(number)) throw wrong();
    at = rest;
    return number;
  };
  double number = take();
  if (at != end && *at == '/') ++at, number /= take();
  while (at != end && *at == ' ') ++at;
  static const std::map<std::string, double, std::less<>> units{{"", 1},
                                                                {"mm", 1},
                                                                {"cm", 10},
                                                                {"m", 1000},
                                                                {"um", 0.001},
                                                                {"in", 25.4},
                                                                {"\"", 25.4},
                                                                {"thou", 0.0254},
                                                                {"mil", 0.0254},
                                                                {"ft", 304.8},
                                                                {"'", 304.8},
                                                                {"rad", 1},
                                                                {"deg", radians_per_degree},
                                                                {"\u00b0", radians_per_degree}};
  const auto unit = units.find(std::string_view(at, static_cast<std::size_t>(end - at)));
  if (unit == units.end() || !std::isfinite(number)) throw wrong();
  return number * unit->second;
}

/// A tool bit of FreeCAD; std::nullopt if Tool cannot represent it.
std::optional<Tool> tool_bit(const JsonFile& file, int number) {
  const Json& size = JsonFile::get(file.root(), "parameter");
  const auto of = [&](const char* key) { return quantity(file, size, key); };
  Tool tool;
  tool.number = number;
  tool.name = JsonFile::text(file.root(), "name");
  if (tool.name.empty()) tool.name = file.path().stem().string();
  tool.diameter = of("Diameter"), tool.flute = of("CuttingEdgeHeight"), tool.length = of("Length"),
  tool.shank = of("ShankDiameter");
  const std::string shape = std::filesystem::path(JsonFile::text(file.root(), "shape")).stem().string();
  if (shape == "endmill") {
    tool.shape = ToolShape::flat;
  } else if (shape == "ballend") {
    tool.shape = ToolShape::ball;
  } else if (shape == "bullnose") {
    // Older files give the flat's width, newer ones the corner radius.
    tool.shape = ToolShape::bull;
    tool.corner_radius = of("CornerRadius");
    if (tool.corner_radius == 0) tool.corner_radius = tool.radius() - of("FlatRadius");
  } else if (shape == "v-bit" || shape == "chamfer") {
    tool.shape = ToolShape::v;
    tool.angle = of("CuttingEdgeAngle"), tool.tip_diameter = of("TipDiameter");
    // The edge ends at the tool's diameter: the height in the file is often different.
    if (tool.angle > 0 && tool.angle < std::numbers::pi)
      tool.flute = std::max(tool.flute, (tool.diameter - tool.tip_diameter) / 2 / std::tan(tool.angle / 2));
  } else if (shape == "drill") {
    tool.shape = ToolShape::drill;
    tool.angle = of("TipAngle");
  } else {
    return std::nullopt;
  }
  if (const double flutes = file.number(JsonFile::get(file.root(), "attribute"), "Flutes"); flutes > 0)
    tool.flutes = static_cast<int>(std::min(flutes, 100.0));
  return checked(file, tool);
}

std::vector<Tool> freecad_library(const JsonFile& file) {
  const Json& rows = JsonFile::get(file.root(), "tools");
  if (!rows.is_array()) throw file.refuse("has no tools");
  std::vector<Tool> tools;
  for (const Json& row : rows) {
    // FreeCAD stores tools in a folder Bit beside the folder of libraries; otherwise the path is
    // relative.
    const std::filesystem::path name = JsonFile::text(row, "path"), beside = file.path().parent_path() / name,
                                bit = file.path().parent_path().parent_path() / "Bit" / name;
    if (name.empty()) throw file.refuse("a tool has no path");
    const JsonFile of(std::filesystem::exists(beside) ? beside : bit);
    if (auto tool = tool_bit(of, file.whole(row, "nr"))) tools.push_back(std::move(*tool));
  }
  return tools;
}

/// A tool of Fusion; std::nullopt if Tool cannot represent it.
std::optional<Tool> fusion_tool(const JsonFile& file, const Json& row) {
  const std::string type = JsonFile::text(row, "type"), unit_name = JsonFile::text(row, "unit");
  const double unit = unit_name == "inches" ? 25.4 : 1;
  const Json& geometry = JsonFile::get(row, "geometry");
  const auto length = [&](const char* key) { return unit * file.number(geometry, key); };
  const auto angle = [&](const char* key) { return radians_per_degree * file.number(geometry, key); };
  Tool tool;
  tool.number = file.whole(JsonFile::get(row, "post-process"), "number");
  tool.name = JsonFile::text(row, "description");
  if (tool.name.empty()) tool.name = type;
  tool.diameter = length("DC"), tool.flute = length("LCF"), tool.length = length("LB"), tool.shank = length("SFDM");
  tool.corner_radius = length("RE");
  if (const double flutes = file.number(geometry, "NOF"); flutes > 0)
    tool.flutes = static_cast<int>(std::min(flutes, 100.0));
  if (type == "flat end mill" || type == "slot mill" || type == "reamer" || type == "counter bore") {
    tool.shape = ToolShape::flat;
  } else if (type == "face mill") {
    tool.shape = tool.corner_radius > 0 ? ToolShape::bull : ToolShape::flat;
  } else if (type == "ball end mill") {
    tool.shape = ToolShape::ball;
  } else if (type == "bull nose end mill") {
    tool.shape = ToolShape::bull;
  } else if (type == "chamfer mill") {
    tool.shape = ToolShape::v;
    tool.angle = 2 * angle("TA"), tool.tip_diameter = length("tip-diameter");
  } else if (type == "tapered mill" && tool.corner_radius > 0) {
    tool.shape = ToolShape::tapered;
    tool.angle = 2 * angle("TA");
  } else if (type == "drill" || type == "spot drill" || type == "counter sink") {
    tool.shape = ToolShape::drill;
    tool.angle = angle("SIG");
  } else {
    return std::nullopt;
  }
  // The greatest diameter of a holder with several segments.
  const Json& holder = JsonFile::get(row, "holder");
  const double holder_unit = JsonFile::text(holder, "unit") == "inches" ? 25.4 : 1;
  if (const Json& segments = JsonFile::get(holder, "segments"); segments.is_array())
    for (const Json& segment : segments) {
      tool.holder_length += holder_unit * file.number(segment, "height");
      for (const char* key : {"lower-diameter", "upper-diameter"})
        tool.holder_diameter = std::max(tool.holder_diameter, holder_unit * file.number(segment, key));
    }
  // Speeds of the first preset.
  if (const Json& presets = JsonFile::get(JsonFile::get(row, "start-values"), "presets");
      presets.is_array() && !presets.empty()) {
    tool.spindle = file.number(presets[0], "n");
    tool.feed = unit * file.number(presets[0], "v_f"), tool.plunge = unit * file.number(presets[0], "v_f_plunge");
  }
  return checked(file, tool);
}

}  // namespace

std::vector<Tool> read_tool_library(const std::filesystem::path& path) {
  const JsonFile file(path);
  if (path.extension() == ".fctl") return freecad_library(file);
  if (path.extension() == ".fctb") {
    if (auto tool = tool_bit(file, 1)) return {std::move(*tool)};
    throw file.refuse(fmt::format("no tool here is of the shape '{:.40}'", JsonFile::text(file.root(), "shape")));
  }
  const Json& rows = JsonFile::get(file.root(), "data");
  if (!rows.is_array())
    throw file.refuse("is no tool library: known are FreeCAD's .fctb and .fctl, and Fusion's .json");
  std::vector<Tool> tools;
  for (const Json& row : rows)
    if (auto tool = fusion_tool(file, row)) tools.push_back(std::move(*tool));
  return tools;
}

}  // namespace fieldfab::cam
