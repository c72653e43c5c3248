/// Tools as unions of convex solids of revolution, for simulation (Hahn 2.2; form tools extend section 7.4).
#pragma once

#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/core/geometry.h"

namespace fieldfab::cam {

/// Function of a part of the tool.
enum class ToolRole : unsigned char {
  cutting,  ///< removes material
  shank,    ///< must not touch material
  holder,   ///< must not touch material
};

/// A convex solid of revolution. Heights are measured along the tool's axis from the tip, mm.
struct Zone {
  enum class Shape : unsigned char {
    ball,     ///< ball of radius r0 with its centre at height z0
    frustum,  ///< frustum of a cone from radius r0 at z0 to radius r1 at z1 above it
    ring,     ///< all points within r1 of a disc of radius r0 at height z0: the corner of a bull-nose and its interior
  };
  Shape shape = Shape::frustum;
  double z0 = 0, z1 = 0, r0 = 0, r1 = 0;
  /// Whether the circles at the ends of a frustum are edges; false where the surface continues smoothly.
  bool lower_edge = true, upper_edge = true;
};

/// Returns the greatest distance of a zone from the tool's axis, mm.
double widest(const Zone& zone);

/// A convex union of zones with one function.
struct ToolPiece {
  ToolRole role = ToolRole::cutting;
  std::vector<Zone> zones;
};

/// A complete tool, with its tip at the origin and its axis along z.
struct ToolSolid {
  std::vector<ToolPiece> pieces;

  /// Greatest distance from the axis, and greatest height above the tip, mm.
  [[nodiscard]] double radius() const;
  [[nodiscard]] double length() const;
  /// Returns all points at a depth of at least `by` mm, piece by piece.
  [[nodiscard]] ToolSolid shrunk(double by) const;
};

/// Position of a tool: its tip, mm, and its axis from the tip towards the spindle, of length 1.
struct ToolPose {
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// Returns the solid of a tool: the cutting part, then shank and holder if their sizes are known. The cutting part is
/// as long as the flutes, otherwise up to the holder, otherwise ten diameters. Throws Error(bad_input) for invalid
/// dimensions.
ToolSolid tool_solid(const Tool& tool);

/// Decomposes a solid of revolution into convex pieces. `section` is a polyline of points (distance from the axis,
/// height), mm, with non-decreasing heights. Throws Error(bad_input) with `place`.
std::vector<ToolPiece> convex_pieces(const std::vector<Vec2>& section, ToolRole role, const std::string& place);

}  // namespace fieldfab::cam
