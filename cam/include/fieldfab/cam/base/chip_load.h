/// Starting values of feed and spindle speed by material: the thickness of the chip that each cutting edge takes, and
/// the speed of the edge, as makers of tools recommend them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/tool.h"

namespace fieldfab::cam {

/// Names of the materials with known chip loads, in alphabetical order.
std::vector<std::string> cut_materials();

/// Thickness of the chip of one cutting edge of a cutter with that diameter, mm: the least of the recommended range.
/// Throws Error(bad_input) for an unknown material or a diameter that is not above 0.
double chip_load(std::string_view material, double diameter);

/// Feeds, mm/min, and spindle speed, revolutions per minute.
struct CuttingValues {
  double feed = 0, plunge = 0, spindle = 0;
  /// Returns the value of a setting of operations: "feed", "plunge" or "spindle"; 0 for others.
  [[nodiscard]] double named(std::string_view setting) const;
};

/// Starting values for a tool in a material. The feed is spindle speed times cutting edges times chip load; the spindle
/// turns as fast as the material and the machine allow, but slower where the machine cannot feed as fast, down to the
/// least recommended speed. Plunges go a third as fast. `max_feed`, `max_spindle`: limits of the machine; 0: none
/// known. A spindle speed of the tool itself is kept. Throws as chip_load() does.
CuttingValues cutting_values(std::string_view material, const Tool& tool, double max_feed, double max_spindle);

}  // namespace fieldfab::cam
