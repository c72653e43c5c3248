/// Tools as solids of revolution for simulation: convex pieces, each with a meaning (Hahn 2.2; form tools go past its
/// section 7.4).
#pragma once

#include <string>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/core/geometry.h"

namespace fieldfab::cam {

/// What a part of the tool does to material that it meets.
enum class ToolRole : unsigned char {
  cutting,  ///< removes it
  shank,    ///< must not touch it
  holder,   ///< must not touch it
};

/// A simple convex solid of revolution. Heights are along the tool's axis from the tip, mm.
struct Zone {
  enum class Shape : unsigned char {
    ball,     ///< centre at height z0, radius r0
    frustum,  ///< from radius r0 at z0 to r1 at z1 above it
    ring,     ///< all within r1 of a disc of radius r0 at height z0: a bull-nose's corner and what is inside of it
  };
  Shape shape = Shape::frustum;
  double z0 = 0, z1 = 0, r0 = 0, r1 = 0;
  /// Whether the circles at a frustum's ends are edges of the piece: not where it goes on smoothly.
  bool lower_edge = true, upper_edge = true;
};

/// Zones whose union is convex.
struct ToolPiece {
  ToolRole role = ToolRole::cutting;
  std::vector<Zone> zones;
};

/// A whole tool, its tip at the origin, its axis along z.
struct ToolSolid {
  std::vector<ToolPiece> pieces;

  /// The greatest distance from the axis and from the tip's height, mm.
  [[nodiscard]] double radius() const;
  [[nodiscard]] double length() const;
  /// Everything of it that is at least `by` mm under its surface, piece by piece.
  [[nodiscard]] ToolSolid shrunk(double by) const;
};

/// A tool's place: its tip, and its axis from there towards the spindle, of length 1.
struct ToolPose {
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// The solid of a cutter: its cutting part as long as its flutes (where no length is known, up to its holder; where that is
/// unknown too, ten times its diameter), then shank and holder where their sizes are known. Throws bad_input for a tool that is
/// none.
ToolSolid tool_solid(const Tool& tool);

/// The convex pieces of a solid of revolution whose half section is a polyline of points (distance from the axis, height), from
/// its lowest point to its highest; heights must not fall. Throws bad_input with `place`.
std::vector<ToolPiece> convex_pieces(const std::vector<Vec2>& section, ToolRole role, const std::string& place);

}  // namespace fieldfab::cam
