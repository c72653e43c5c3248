#include "control.h"

#include <cmath>
#include <numbers>

#include "fieldfab/core/angle.h"
#include "travel.h"

namespace fieldfab::cam::gcode {
namespace {

/// Conversion of angles: radians in the interface, degrees in programs.
AxisValues in_degrees(AxisValues values) {
  for (std::size_t k = 3; k < 6; ++k) values.at[k] *= degrees_per_radian;
  return values;
}

}  // namespace

double Modes::spindle_at(const AxisValues& place) const {
  double turns = speed;
  if (constant_surface) {
    // S is in m/min (feet/min under G20); X is the radius.
    const double around = 2 * std::numbers::pi * std::abs(place.at[0]), surface = speed * (inch ? 304.8 : 1000);
    turns = most_speed > 0 ? most_speed : 1e5;
    if (around > 0) turns = std::min(turns, surface / around);
  }
  return turns * spindle;
}

void Modes::set_feed(Motion& canonical, const AxisValues& from) const {
  const Travel travel = travel_of(from, canonical);
  if (feed_mode == 930) {
    const double along = travel.along();
    canonical.feed = feed * (along > 0 ? along : 1);
    canonical.seconds = -1;
    return;
  }
  const bool rotary = travel.xyz == 0 && travel.uvw == 0 && travel.rotary > 0;
  canonical.feed = feed * (rotary ? radians_per_degree : feed_unit);
  if (feed_mode == 950) canonical.feed *= std::abs(spindle == 0 ? speed : spindle_at(canonical.end));
}

Control::Control(const ReadingOptions& options, const PredefinedParameters& predefined)
    : dialect(options.dialect), tools(options.tools), parameters(predefined) {
  modes.inch = options.inch;
  if (dialect != Dialect::linuxcnc) modes.motion = 0, modes.retract_to_start = true;
  const auto store = [&](int first, const AxisValues& values) {
    for (int k = 0; k < 9; ++k) parameters.stored(first + k) = in_degrees(values).at[static_cast<std::size_t>(k)];
  };
  store(number::first_home, options.home[0]);
  store(number::second_home, options.home[1]);
  for (int k = 0; k < 9; ++k) store(number::system_start(k + 1), options.work_offsets[static_cast<std::size_t>(k)]);
  parameters.stored(number::coordinate_system) = 1;
  parameters.stored(number::input_value) = -1;
  frame = stored_frame();
  at = frame.of_axes(in_degrees(options.start));
}

const ToolEntry& Control::tool_entry(int number) const {
  static const ToolEntry nothing;
  const auto found = tools.find(number);
  if (found != tools.end()) return found->second;
  if (number == 0) return nothing;
  refuse("tool {} is not in the tool table", number);
}

Frame Control::stored_frame() const {
  Frame stored = frame;
  const int first = number::system_start(modes.system);
  for (int k = 0; k < 9; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    stored.origin.at[axis] = parameters.stored(first + k);
    stored.axis_offset.at[axis] =
        parameters.stored(number::offset_active) != 0 ? parameters.stored(number::axis_offset + k) : 0;
  }
  stored.rotation = parameters.stored(first + 9);
  return stored;
}

double Control::word(const Block& block, char letter) const {
  const double value = block[letter];
  if (letter >= 'a' && letter <= 'c') return value;
  return modes.length(letter == 'x' && modes.diameter ? value / 2 : value);
}

AxisValues Control::target(const Block& block) const {
  AxisValues to = at;
  for (std::size_t k = 0; k < axis_letters.size(); ++k)
    if (const char letter = axis_letters[k]; block.has(letter))
      to.at[k] = modes.absolute ? word(block, letter) : at.at[k] + word(block, letter);
  if (block.has_radius || block.has_angle) {
    if (block.has('x') || block.has('y')) refuse("@ and ^ do not go with X and Y");
    if (modes.plane != ArcPlane::xy) refuse("@ and ^ are of the plane G17");
    double radius = std::hypot(at.at[0], at.at[1]), angle = std::atan2(at.at[1], at.at[0]);
    if (block.has_angle && !block.has_radius && radius == 0) refuse("^ without @ at the origin");
    if (block.has_radius) radius = modes.absolute ? modes.length(block.radius) : radius + modes.length(block.radius);
    if (block.has_angle)
      angle = modes.absolute ? block.angle * radians_per_degree : angle + block.angle * radians_per_degree;
    to.at[0] = radius * std::cos(angle);
    to.at[1] = radius * std::sin(angle);
  }
  return to;
}

void Control::require_feed(const Block& block) {
  if (modes.feed_mode == 930) {
    if (!block.has('f') || modes.feed <= 0) refuse("under G93 each feed needs its F word, above 0");
  } else if (modes.feed <= 0 && dialect != Dialect::linuxcnc) {
    note("a feed without a feed rate (F): its time is not counted");
  } else if (modes.feed <= 0) {
    refuse("a feed without a feed rate: F is missing or 0");
  } else if (modes.feed_mode == 950 && modes.speed == 0) {
    refuse("a feed per revolution (G95) while the spindle's speed is 0");
  }
}

}  // namespace fieldfab::cam::gcode
