// Transformation between program and machine coordinates.
#pragma once

#include <optional>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// G68: rotation of the program about a point of a plane.
struct Turned {
  ArcPlane plane = ArcPlane::xy;
  Vec2 about = Vec2::Zero();
  double angle = 0;  ///< degrees, anticlockwise
};

/// Indices of a plane's axes: the first and the second span it, the third is normal to it.
struct PlaneAxes {
  std::size_t first, second, third;
};
constexpr PlaneAxes axes_of(ArcPlane plane) {
  switch (plane) {
    case ArcPlane::zx: return {2, 0, 1};
    case ArcPlane::yz: return {1, 2, 0};
    default: return {0, 1, 2};
  }
}

/// A position's point in a plane.
inline Vec2 in_plane(const AxisValues& values, PlaneAxes axes) {
  return {values.at[axes.first], values.at[axes.second]};
}
/// Replaces the two coordinates of a plane.
inline void set_in_plane(AxisValues& values, PlaneAxes axes, const Vec2& point) {
  values.at[axes.first] = point.x(), values.at[axes.second] = point.y();
}

/// Chain of transformations from program to machine coordinates: G68, then G92 or G52, then the
/// work offset with its rotation about z. All in mm and degrees.
struct Frame {
  AxisValues origin;       ///< of the work coordinate system
  double rotation = 0;     ///< of that system, degrees (G10 L2 R)
  AxisValues axis_offset;  ///< G92, G52
  AxisValues tool;         ///< length compensation
  std::optional<Turned> turned;

  /// Position of the tool's tip in machine coordinates.
  [[nodiscard]] AxisValues tip(const AxisValues& program) const;
  /// Corresponding position of the axes.
  [[nodiscard]] AxisValues axes(const AxisValues& program) const { return added(tip(program), tool, 1); }
  /// Program coordinates for a position of the tip, or of the axes.
  [[nodiscard]] AxisValues of_tip(const AxisValues& tip) const;
  [[nodiscard]] AxisValues of_axes(const AxisValues& axes) const { return of_tip(added(axes, tool, -1)); }
  /// Whether an arc in that plane is mapped to an arc in that plane.
  [[nodiscard]] bool keeps(ArcPlane plane) const {
    return (rotation == 0 || plane == ArcPlane::xy) && (!turned || turned->plane == plane);
  }
  static AxisValues added(const AxisValues& a, const AxisValues& b, double sign);
};

}  // namespace fieldfab::cam::gcode
