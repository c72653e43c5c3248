// Distances that motions travel.
#pragma once

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// Length of an arc in its plane, mm. The sign of `turns` is the direction; equal ends mean a full circle.
double arc_length(const Vec2& from, const Vec2& to, const Vec2& centre, int turns);

/// Distances of a motion along its three groups of axes.
struct Travel {
  double xyz = 0;     ///< mm; of an arc, along the helix
  double uvw = 0;     ///< mm
  double rotary = 0;  ///< radians

  /// The distance that a feed refers to: that along the first group that moves.
  [[nodiscard]] double along() const { return xyz > 0 ? xyz : uvw > 0 ? uvw : rotary; }
};

/// Travel of a motion from a position. Both are in program coordinates: mm, degrees.
Travel travel_of(const AxisValues& from, const Motion& motion);

}  // namespace fieldfab::cam::gcode
