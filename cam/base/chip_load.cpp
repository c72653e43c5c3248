#include "fieldfab/cam/base/chip_load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fieldfab/cam/base/setting.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

constexpr double inch = 25.4;
constexpr std::array<double, 4> diameters{inch / 8, inch / 4, 3 * inch / 8, inch / 2};
constexpr double usual_spindle = 24000;  // greatest speed of a router whose machine names none

struct CutMaterial {
  std::string_view name;
  double slowest, fastest;           // cutting speed, m/min
  std::array<double, 4> chip_loads;  // at these diameters, inches for each cutting edge, least of the range
};

/// Chip loads: the chart "Feeds and Speeds" of cutter-shop.com. Cutting speeds: woods and aluminium from "CNC Feed and
/// Speed" of cncvox.com.au, plastics from the milling guidelines of curbellplastics.com.
constexpr CutMaterial materials[] = {
    {"acrylic", 280, 500, {0.003, 0.008, 0.010, 0.012}},      {"aluminium", 120, 250, {0.003, 0.005, 0.006, 0.008}},
    {"hard plastic", 280, 500, {0.002, 0.006, 0.008, 0.010}}, {"hardwood", 300, 600, {0.003, 0.009, 0.015, 0.019}},
    {"mdf", 300, 600, {0.004, 0.013, 0.020, 0.025}},          {"plywood", 300, 600, {0.004, 0.011, 0.017, 0.021}},
    {"soft plastic", 280, 500, {0.003, 0.007, 0.010, 0.012}},
};

const CutMaterial& material_named(std::string_view name) {
  const auto* const found = std::ranges::find(materials, name, &CutMaterial::name);
  if (found != std::end(materials)) return *found;
  const std::vector<std::string> names = cut_materials();
  throw Error(ErrorKind::bad_input, "material",
              fmt::format("no chip load is known for '{}', only for {}{}", name, fmt::join(names, ", "),
                          suggestion(std::string(name), names)));
}

double chip_load_of(const CutMaterial& material, double diameter) {
  if (!(diameter > 0)) throw Error(ErrorKind::bad_input, "diameter", "a chip load needs a diameter above 0");
  const auto& loads = material.chip_loads;
  if (diameter <= diameters.front()) return inch * loads.front() * diameter / diameters.front();
  for (std::size_t i = 1; i < diameters.size(); ++i)
    if (diameter <= diameters[i]) {
      const double share = (diameter - diameters[i - 1]) / (diameters[i] - diameters[i - 1]);
      return inch * (loads[i - 1] + share * (loads[i] - loads[i - 1]));
    }
  return inch * loads.back();
}

}  // namespace

double CuttingValues::named(std::string_view setting) const {
  return setting == "feed" ? feed : setting == "plunge" ? plunge : setting == "spindle" ? spindle : 0;
}

std::vector<std::string> cut_materials() {
  std::vector<std::string> names;
  for (const CutMaterial& material : materials) names.emplace_back(material.name);
  return names;
}

double chip_load(std::string_view material, double diameter) {
  return chip_load_of(material_named(material), diameter);
}

CuttingValues cutting_values(std::string_view name, const Tool& tool, double max_feed, double max_spindle) {
  const CutMaterial& material = material_named(name);
  const double chip = tool.flutes * chip_load_of(material, tool.diameter);  // mm for each turn
  const double around = std::numbers::pi * tool.diameter / 1000;            // m for each turn
  const double most = max_spindle > 0 ? max_spindle : usual_spindle;
  CuttingValues values;
  values.spindle = std::min(material.fastest / around, most);
  if (max_feed > 0 && values.spindle * chip > max_feed)
    values.spindle = std::max(max_feed / chip, std::min(material.slowest / around, most));
  values.spindle = tool.spindle > 0 ? tool.spindle : std::floor(values.spindle / 10) * 10;
  values.feed = values.spindle * chip;
  if (max_feed > 0) values.feed = std::min(values.feed, max_feed);
  values.feed = std::max(1.0, std::floor(values.feed));
  values.plunge = std::max(1.0, std::floor(values.feed / 3));
  return values;
}

}  // namespace fieldfab::cam
