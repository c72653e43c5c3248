#include "machine_motions.h"

#include <cmath>

#include "base/chords.h"
#include "fieldfab/core/angle.h"
#include "travel.h"

namespace fieldfab::cam::gcode {
void MachineMotions::give(Motion motion) {
  const AxisValues to = motion.end;
  for (const double value : to.at)
    if (!(std::abs(value) < 1e12)) refuse("a move to {}, which no machine can reach", value);
  if (motion.seconds < 0) motion.seconds = 60 * travel_of(at_, motion).along() / motion.feed;
  const bool arc = motion.kind == Motion::Kind::arc;
  if (arc && !frame_.keeps(motion.plane)) return give_chords(motion);
  motion.end = frame_.tip(to);
  for (std::size_t k = 3; k < 6; ++k) motion.end.at[k] *= radians_per_degree;
  if (arc) {
    const PlaneAxes axes = axes_of(motion.plane);
    AxisValues centre = to;
    set_in_plane(centre, axes, motion.centre);
    motion.centre = in_plane(frame_.tip(centre), axes);
  }
  at_ = to;
  next_(motion);
}

/// Short feeds for an arc that the frame rotates out of its plane.
void MachineMotions::give_chords(const Motion& arc) {
  notes_.add(arc.line, "an arc in a plane that the rotation in force does not keep: given as short straight feeds");
  const PlaneAxes axes = axes_of(arc.plane);
  const AxisValues from = at_;
  const Vec2 begin = in_plane(from, axes) - arc.centre, end = in_plane(arc.end, axes) - arc.centre;
  const double radius = begin.norm(), radius_end = end.norm();
  const double sweep =
      arc_length(begin, end, Vec2::Zero(), arc.turns) / std::max(radius, 1e-9) * (arc.turns > 0 ? 1 : -1);
  const double step = chord_angle(radius, chord_tolerance);
  const int count = std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / std::max(step, 1e-4))), 1, 1'000'000);
  const double start_angle = std::atan2(begin.y(), begin.x());
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count, angle = start_angle + share * sweep;
    Motion motion = arc;
    motion.kind = Motion::Kind::feed;
    motion.turns = 0;
    motion.centre = Vec2::Zero();
    if (arc.seconds > 0) motion.seconds = arc.seconds / count;
    for (std::size_t k = 0; k < 9; ++k) motion.end.at[k] = from.at[k] + share * (arc.end.at[k] - from.at[k]);
    const double r = radius + share * (radius_end - radius);
    if (i < count) {
      motion.end.at[axes.first] = arc.centre.x() + r * std::cos(angle);
      motion.end.at[axes.second] = arc.centre.y() + r * std::sin(angle);
    }
    give(motion);
  }
}

}  // namespace fieldfab::cam::gcode
