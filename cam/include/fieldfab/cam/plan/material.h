/// In-process stock during planning: heights of the material, as seen from one plane.
#pragma once

#include <vector>

#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// A height map of the material. Heights are never too low, except by the slope over half a cell along the edge of a
/// cut. Used for entries and for omitting air cuts; the simulation verifies programs.
class Material {
 public:
  /// A block up to height `top`, with cells of edge `cell`, mm.
  Material(const Rectangle& block, double top, double cell);

  /// Removes the volume swept by the tool on cutting moves, given in the same coordinates.
  void cut(const std::vector<Move>& moves, const Profile& profile);
  /// Returns the greatest height within `radius` of a point, mm; minus infinity outside the block.
  [[nodiscard]] double highest(const Vec2& p, double radius) const;
  [[nodiscard]] const HeightMap& heights() const { return heights_; }
  HeightMap& heights() { return heights_; }

 private:
  HeightMap heights_;
};

/// Returns the parts of paths on which a tool of that radius meets material, slightly extended at both ends. A closed
/// path that meets material everywhere stays closed.
std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius);

}  // namespace fieldfab::cam
