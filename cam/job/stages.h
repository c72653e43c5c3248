/// The tables of stages, one per file.
#pragma once

#include "fieldfab/cam/job/stage.h"
#include "fieldfab/core/angle.h"

namespace fieldfab::cam {

std::vector<Stage> conversion_stages();
std::vector<Stage> flat_stages();
std::vector<Stage> surface_stages();

/// Constructors of settings for the tables.
inline Setting number(std::string name, std::string unit, double standard, std::string help) {
  Setting s;
  s.name = std::move(name), s.unit = std::move(unit), s.standard = standard, s.help = std::move(help);
  return s;
}
inline Settings operator+(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
inline Setting above_zero(Setting s) { return s.lower = 0, s.lower_open = true, s; }
inline Setting whole(Setting s) { return s.whole = true, s; }
/// A setting that is used only together with another one: if that has one of these values, by
/// default any value except 0 and false.
inline Setting only_with(std::string needs, Setting s, std::vector<std::string> values = {}) {
  s.needs = std::move(needs), s.needs_values = std::move(values);
  return s;
}
inline Setting at_least(double lower, Setting s) { return s.lower = lower, s; }
inline Setting between(double lower, double upper, Setting s) { return s.lower = lower, s.upper = upper, s; }
inline Setting flag(std::string name, bool standard, std::string help) {
  Setting s;
  s.name = std::move(name), s.standard = standard, s.help = std::move(help);
  return s;
}
inline Setting choice(std::string name, std::vector<std::string> choices, std::string help) {
  Setting s;
  s.name = std::move(name), s.standard = choices[0], s.choices = std::move(choices), s.help = std::move(help);
  return s;
}

/// Settings of area clearing, without the stepover.
inline Settings clear_settings() {
  return {choice("pattern", {"rings", "adaptive"},
                 "rings along the walls, or constant engagement: never more than a straight pass has")};
}
inline ClearSettings clear_of(const Values& values, double stepover, const Tool& tool) {
  ClearSettings clear;
  clear.stepover = stepover;
  clear.adaptive = values.text("pattern") == "adaptive";
  clear.helix_radius = tool.helix_radius();
  clear.ramp_angle = to_radians(values.number("ramp_angle"));
  return clear;
}
}  // namespace fieldfab::cam
