#include "camotics_setup.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

using Json = nlohmann::json;

class CamoticsReader {
 public:
  CamoticsReader(const std::filesystem::path& path, Progress& progress) : path_(path), progress_(progress) {}

  SimulationSetup read() {
    const std::string text = read_file(path_, 16 << 20);
    const Json project = Json::parse(text, nullptr, false);
    if (!project.is_object()) throw refuse("is no project of CAMotics: JSON is wanted");
    setup_.file = path_.string();
    setup_.name = path_.stem().string();
    setup_.inch = unit_of(project) != 1;
    read_programs(project);
    read_tools(project);
    read_workpiece(project);
    const double resolution = number(project, "resolution", 0);
    // CAMotics' default resolution is about 30 cells; ours shows more detail.
    const double usual = StockSettings::usual_cell(setup_.stock_box);
    setup_.sampling.cell = resolution > 0 ? std::min(resolution, usual) : usual;
    return std::move(setup_);
  }

 private:
  [[nodiscard]] Error refuse(const std::string& what) const { return {ErrorKind::bad_input, path_.string(), what}; }

  [[nodiscard]] double number(const Json& table, const char* key, double otherwise) const {
    const auto found = table.find(key);
    if (found == table.end() || found->is_null()) return otherwise;
    if (!found->is_number() || !std::isfinite(found->get<double>()))
      throw refuse(fmt::format("'{}' is no number", key));
    return found->get<double>();
  }
  [[nodiscard]] std::string text(const Json& table, const char* key, const char* otherwise) const {
    const auto found = table.find(key);
    if (found == table.end() || found->is_null()) return otherwise;
    if (!found->is_string()) throw refuse(fmt::format("'{}' is no text", key));
    return found->get<std::string>();
  }
  /// Length of the table's unit, mm.
  [[nodiscard]] double unit_of(const Json& table) const {
    const std::string units = text(table, "units", "metric");
    if (units == "metric" || units == "mm") return 1;
    if (units == "imperial" || units == "inch") return 25.4;
    throw refuse(fmt::format("units are '{:.40}'; known are metric and imperial", units));
  }

  void read_programs(const Json& project) {
    const auto files = project.find("files");
    if (files == project.end() || !files->is_array()) return;
    for (const Json& file : *files) {
      if (!file.is_string()) throw refuse("'files' are names");
      setup_.programs.push_back(path_.parent_path() / file.get<std::string>());
    }
  }

  void read_tools(const Json& project) {
    const auto tools = project.find("tools");
    if (tools == project.end() || !tools->is_object()) throw refuse("has no tools");
    for (const auto& [key, table] : tools->items()) {
      if (!table.is_object()) throw refuse(fmt::format("tool '{:.20}' is no table", key));
      Tool tool;
      const double number_of_tool = number(table, "number", std::atoi(key.c_str()));
      if (!(number_of_tool >= 0 && number_of_tool <= 99999) || number_of_tool != std::floor(number_of_tool))
        throw refuse(fmt::format("tool '{:.20}' has no whole number", key));
      tool.number = static_cast<int>(number_of_tool);
      const double unit = unit_of(table);
      tool.diameter = unit * number(table, "diameter", 0);
      tool.flute = unit * number(table, "length", 0);
      tool.name = text(table, "description", "");
      const std::string shape = text(table, "shape", "cylindrical");
      if (shape == "cylindrical") {
        tool.shape = ToolShape::flat;
      } else if (shape == "ballnose") {
        tool.shape = ToolShape::ball;
      } else if (shape == "conical" || shape == "snubnose") {
        tool.shape = ToolShape::v;
        tool.tip_diameter = shape == "snubnose" ? unit * number(table, "snub_diameter", 0) : 0;
        tool.angle = 2 * std::atan2((tool.diameter - tool.tip_diameter) / 2, tool.flute);
      } else if (shape == "spheroid") {
        throw refuse(fmt::format("tool {}: spheroids are not known here", tool.number));
      } else {
        throw refuse(fmt::format("tool {}: there is no shape '{:.40}'", tool.number, shape));
      }
      if (!(tool.diameter > 0) || !(tool.flute > 0))
        throw refuse(fmt::format("tool {}: diameter and length must be above 0", tool.number));
      if (tool.name.empty()) tool.name = fmt::format("{:.4g} mm {}", tool.diameter, name_of(tool.shape));
      try {
        (void)tool.profile();
      } catch (const Error& error) {
        throw refuse(fmt::format("tool {}: {}", tool.number, error.what()));
      }
      if (!setup_.tools.emplace(tool.number, tool).second)
        throw refuse(fmt::format("there are two tools with number {}", tool.number));
    }
    if (setup_.tools.empty()) throw refuse("has no tools");
  }

  void read_workpiece(const Json& project) {
    const auto workpiece = project.find("workpiece");
    if (workpiece == project.end() || !workpiece->is_object()) throw refuse("has no workpiece");
    const auto automatic = workpiece->find("automatic");
    if (automatic != workpiece->end() && automatic->is_boolean() && automatic->get<bool>()) {
      setup_.stock_box = box_of_programs(number(*workpiece, "margin", 5));
      return;
    }
    const auto bounds = workpiece->find("bounds");
    if (bounds == workpiece->end() || !bounds->is_object()) throw refuse("the workpiece has no bounds");
    const auto corner = [&](const char* key) {
      const auto list = bounds->find(key);
      if (list == bounds->end() || !list->is_array() || list->size() != 3)
        throw refuse(fmt::format("'{}' is three numbers", key));
      Vec3 place;
      for (std::size_t i = 0; i < 3; ++i) {
        if (!(*list)[i].is_number()) throw refuse(fmt::format("'{}' is three numbers", key));
        place[static_cast<Eigen::Index>(i)] = (*list)[i].get<double>();
      }
      return place;
    };
    setup_.stock_box = {corner("min"), corner("max")};
    if (!setup_.stock_box.valid() || setup_.stock_box.size().minCoeff() <= 0) throw refuse("the workpiece has no size");
  }

  /// Bounding box of the feeds of the project's programs, with a margin of `margin` percent as in
  /// CAMotics. Its top is z = 0 if the feeds start below that.
  [[nodiscard]] Box box_of_programs(double margin) const {
    Box box{Vec3::Constant(INFINITY), Vec3::Constant(-INFINITY)};
    for (const std::filesystem::path& program : setup_.programs) {
      if (program.extension() == ".tpl")
        throw refuse(fmt::format("{}: programs in JavaScript (TPL) are not run", program.string()));
      ReadingOptions options;
      options.inch = setup_.inch;
      for (const auto& [number, tool] : setup_.tools) options.tools[number] = {Vec3::Zero(), tool.diameter};
      Vec3 at = Vec3::Zero();
      const auto take = [&](const Vec3& place) { box = {box.lower.cwiseMin(place), box.upper.cwiseMax(place)}; };
      (void)read_gcode(
          read_file(program, 1 << 30), program.string(), options,
          [&](const Motion& motion) {
            if (motion.kind == Motion::Kind::feed || motion.kind == Motion::Kind::arc) take(at), take(motion.end.xyz());
            at = motion.end.xyz();
          },
          progress_);
    }
    if (!box.valid()) throw refuse("the workpiece is to be as large as the programs' paths, and no program cuts");
    const double around = margin / 100 * box.size().maxCoeff();
    box.upper.z() = std::min(box.upper.z(), 0.0);
    box = {box.lower - Vec3::Constant(around), box.upper + Vec3(around, around, 0)};
    if (box.size().minCoeff() <= 0) throw refuse("the workpiece has no size");
    return box;
  }

  std::filesystem::path path_;
  Progress& progress_;
  SimulationSetup setup_;
};

}  // namespace

SimulationSetup read_camotics(const std::filesystem::path& path, Progress& progress) {
  return CamoticsReader(path, progress).read();
}

}  // namespace fieldfab::cam
