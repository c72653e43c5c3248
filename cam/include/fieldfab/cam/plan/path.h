/// Paths: what a tool's tip follows, or a beam's middle.
#pragma once

#include <span>
#include <vector>

#include "fieldfab/cam/plan/plane.h"

namespace fieldfab::cam {

/// How the tool goes on from a vertex: cutting; getting into the material; or through what is cut already.
enum class Pace { cut, enter, link };

/// A vertex of a path and the way on from it.
struct PathPoint {
  Vec3 at = Vec3::Zero();  ///< mm
  /// The tangent of a quarter of the angle that the way to the next vertex turns through about z: 0 is straight, 1 a half circle
  /// anticlockwise seen from above, negative clockwise (DXF's bulge). z changes evenly along it.
  double bulge = 0;
  Vec3 axis = Vec3::UnitZ();  ///< from the tip towards the spindle, of length 1
  Pace pace = Pace::cut;
};

/// A run of the tool without leaving the material.
struct Path {
  std::vector<PathPoint> points;
  bool closed = false;  ///< goes on from the last vertex to the first
  int level = 0;        ///< levels are cut in ascending order

  [[nodiscard]] Rectangle bounds() const;  ///< of the vertices and the arcs between them
  [[nodiscard]] double length() const;     ///< mm
};

/// Turns a path round: from its last vertex to its first.
void reverse(Path& path);

/// An arc between two vertices, seen from above.
struct Arc {
  Vec2 centre;
  double radius, turn;  ///< turn: the angle, radians, positive anticlockwise
};
Arc arc_between(const Vec2& from, const Vec2& to, double bulge);
/// Length of the way from one place to another, straight or bent, mm.
double length_between(const Vec3& from, const Vec3& to, double bulge);
/// The place at a share of it, from 0 to 1.
Vec3 place_between(const Vec3& from, const Vec3& to, double bulge, double share);

/// The points of a path at distances of at most `step` along arcs, and its vertices; a closed one ends where it begins.
std::vector<PathPoint> points_along(const Path& path, double step);

/// A polyline as lines and arcs at height z, nowhere farther from it than `tolerance`, mm. Arcs turn by at most a half circle.
Path fit_arcs(std::span<const Vec2> points, bool closed, double z, double tolerance);

/// Leaves out vertices of a path without arcs that lie within `tolerance` of the straight way past them.
std::vector<Vec3> simplified(std::span<const Vec3> points, double tolerance);

}  // namespace fieldfab::cam
