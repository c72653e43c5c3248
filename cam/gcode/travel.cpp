#include "travel.h"

#include <cmath>
#include <numbers>

#include "fieldfab/core/angle.h"
#include "frame.h"

namespace fieldfab::cam::gcode {
namespace {

/// Distance along three axes from the first one on.
double distance(const AxisValues& a, const AxisValues& b, std::size_t first) {
  double sum = 0;
  for (std::size_t k = first; k < first + 3; ++k) sum += (b.at[k] - a.at[k]) * (b.at[k] - a.at[k]);
  return std::sqrt(sum);
}

}  // namespace

double arc_length(const Vec2& from, const Vec2& to, const Vec2& centre, int turns) {
  const Vec2 a = from - centre, b = to - centre;
  const double around = 2 * std::numbers::pi;
  double sweep = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
  if (turns < 0) sweep = -sweep;
  while (sweep <= 1e-12) sweep += around;  // no angle means a full circle
  while (sweep > around + 1e-12) sweep -= around;
  return (sweep + around * (std::abs(turns) - 1)) * a.norm();
}

Travel travel_of(const AxisValues& from, const Motion& motion) {
  const AxisValues& to = motion.end;
  Travel travel{distance(from, to, 0), distance(from, to, 6), distance(from, to, 3) * radians_per_degree};
  if (motion.kind == Motion::Kind::arc) {
    const PlaneAxes axes = axes_of(motion.plane);
    const double flat = arc_length(in_plane(from, axes), in_plane(to, axes), motion.centre, motion.turns);
    travel.xyz = std::hypot(flat, to.at[axes.third] - from.at[axes.third]);
  }
  return travel;
}

}  // namespace fieldfab::cam::gcode
