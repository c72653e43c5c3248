/// Paths of a tool tip or of a beam's centre.
#pragma once

#include <span>
#include <vector>

#include "fieldfab/cam/plan/plane.h"

namespace fieldfab::cam {

/// Kind of motion from a vertex: cutting, entering material, or crossing a cleared area.
enum class Pace { cut, enter, link };

/// A vertex of a path, with the segment that follows it.
struct PathPoint {
  Vec3 at = Vec3::Zero();  ///< length, mm
  /// Bulge of the segment, as in DXF: the tangent of a quarter of the arc's angle about z. 0 is straight, 1 a half
  /// circle counter-clockwise seen from above; negative is clockwise. z changes linearly along it.
  double bulge = 0;
  Vec3 axis = Vec3::UnitZ();  ///< tool axis from the tip towards the spindle, of length 1
  Pace pace = Pace::cut;
};

/// A path of the tool that does not leave the material.
struct Path {
  std::vector<PathPoint> points;
  bool closed = false;  ///< whether a segment leads from the last vertex to the first
  int level = 0;        ///< levels are cut in ascending order

  [[nodiscard]] Rectangle bounds() const;  ///< bounding rectangle of vertices and arcs
  [[nodiscard]] double length() const;     ///< mm
};

/// Reverses a path.
void reverse(Path& path);

/// An arc between two vertices, seen from above.
struct Arc {
  Vec2 centre;
  double radius, turn;  ///< turn: the angle, radians, positive counter-clockwise
};
/// Returns the arc of a bulge; `bulge` must not be 0.
Arc arc_between(const Vec2& from, const Vec2& to, double bulge);
/// Length of a straight or circular segment between two points, mm.
double length_between(const Vec3& from, const Vec3& to, double bulge);
/// Returns the point at a fraction of the segment, from 0 to 1.
Vec3 place_between(const Vec3& from, const Vec3& to, double bulge, double share);

/// Returns the vertices of a path, and points on its arcs at distances of at most `step` mm. A closed path ends at its
/// first point.
std::vector<PathPoint> points_along(const Path& path, double step);

/// Fits lines and arcs at height z to a polyline, with a deviation of at most `tolerance` mm. Arcs turn by at most a
/// half circle.
Path fit_arcs(std::span<const Vec2> points, bool closed, double z, double tolerance);

/// Simplifies a path without arcs: removes vertices within `tolerance` mm of the straight segment that replaces them.
std::vector<Vec3> simplified(std::span<const Vec3> points, double tolerance);

}  // namespace fieldfab::cam
