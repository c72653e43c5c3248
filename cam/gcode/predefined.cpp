#include "predefined.h"

namespace fieldfab::cam::gcode {
namespace {

double flag(bool on) { return on ? 1.0 : 0.0; }

}  // namespace

double ControlParameters::numbered(int number) const {
  const double unit = control_.modes.unit();
  if (number == number::tool) return control_.tool;
  if (number >= 5401 && number <= 5403) return control_.tool_entry(control_.tool).offset[number - 5401] / unit;
  if (number == 5410) return control_.tool_entry(control_.tool).diameter / unit;
  if (number >= 5420 && number <= 5428) {
    if (stream_.compensation_side() != 0) refuse("the position cannot be asked for while cutter compensation is on");
    const auto axis = static_cast<std::size_t>(number - 5420);
    return axis >= 3 && axis < 6 ? control_.at.at[axis] : control_.at.at[axis] / unit;
  }
  return 0;
}

std::optional<double> ControlParameters::named(std::string_view name) const {
  if (const auto found = position(name)) return found;
  if (const auto found = mode(name)) return found;
  if (const auto found = state(name)) return found;
  if (name.starts_with("_hal[") || name.starts_with("_ini[")) {
    control_.notes.add(flow_.line(), fmt::format("#<{}> is 0: there is no such thing here", shown(name)));
    return 0;
  }
  return std::nullopt;
}

/// Names such as _x and _abs_x.
std::optional<double> ControlParameters::position(std::string_view name) const {
  const std::size_t axis = name.empty() ? std::string_view::npos : axis_letters.find(name.back());
  if (axis == std::string_view::npos) return std::nullopt;
  if (name.size() == 2) return numbered(5420 + static_cast<int>(axis));
  if (name.size() == 6 && name.starts_with("_abs_")) {
    const double value = control_.frame.axes(stream_.position()).at[axis];
    return axis >= 3 && axis < 6 ? value : value / control_.modes.unit();
  }
  return std::nullopt;
}

std::optional<double> ControlParameters::mode(std::string_view name) const {
  const Modes& modes = control_.modes;
  if (name == "_motion_mode") return modes.motion;
  if (name == "_plane") return modes.plane == ArcPlane::xy ? 170 : modes.plane == ArcPlane::zx ? 180 : 190;
  if (name == "_metric") return flag(!modes.inch);
  if (name == "_imperial") return flag(modes.inch);
  if (name == "_absolute") return flag(modes.absolute);
  if (name == "_incremental") return flag(!modes.absolute);
  if (name == "_inverse_time") return flag(modes.feed_mode == 930);
  if (name == "_units_per_minute") return flag(modes.feed_mode == 940);
  if (name == "_units_per_rev") return flag(modes.feed_mode == 950);
  if (name == "_coord_system") return modes.system <= 6 ? 530 + 10 * modes.system : 584 + modes.system;
  if (name == "_retract_r_plane") return flag(!modes.retract_to_start);
  if (name == "_retract_old_z") return flag(modes.retract_to_start);
  if (name == "_spindle_rpm_mode") return flag(!modes.constant_surface);
  if (name == "_spindle_css_mode") return flag(modes.constant_surface);
  if (name == "_ijk_absolute_mode") return flag(modes.arcs_absolute);
  if (name == "_lathe_diameter_mode") return flag(modes.diameter);
  if (name == "_lathe_radius_mode") return flag(!modes.diameter);
  if (name == "_spindle_on") return flag(modes.spindle != 0);
  if (name == "_spindle_cw") return flag(modes.spindle > 0);
  if (name == "_mist") return flag(modes.mist);
  if (name == "_flood") return flag(modes.flood);
  if (name == "_feed_override") return flag(modes.feed_override);
  if (name == "_speed_override") return flag(modes.speed_override);
  if (name == "_feed") return modes.feed;
  if (name == "_rpm") return modes.speed;
  return std::nullopt;
}

/// Names of state that M70 does not save.
std::optional<double> ControlParameters::state(std::string_view name) const {
  const int side = stream_.compensation_side();
  if (name == "_vmajor") return 2.9;
  if (name == "_vminor") return 0;
  if (name == "_line") return flow_.line();
  if (name == "_ccomp") return side == 0 ? 400 : side > 0 ? 410 : 420;
  if (name == "_tool_offset") return flag(control_.frame.tool != AxisValues{});
  if (name == "_adaptive_feed" || name == "_feed_hold" || name == "_task" || name == "_remap_level") return 0;
  if (name == "_current_tool" || name == "_current_pocket") return control_.tool;
  if (name == "_selected_tool" || name == "_selected_pocket") return control_.selected_tool;
  if (name == "_value") return flow_.value();
  if (name == "_value_returned") return flag(flow_.value_returned());
  if (name == "_call_level") return static_cast<double>(flow_.depth());
  return std::nullopt;
}

}  // namespace fieldfab::cam::gcode
