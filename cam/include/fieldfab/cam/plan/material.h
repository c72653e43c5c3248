/// What is left of the stock while a program is planned: heights of the material as one plane sees it.
#pragma once

#include <vector>

#include "fieldfab/cam/plan/program.h"

namespace fieldfab::cam {

/// Heights on a lattice, never below the true ones but for half a cell's slope along a cut's edge. Good for planning entries and
/// leaving out air; the simulation is what proves programs.
class Material {
 public:
  /// A block up to `top`; cells of that size, mm.
  Material(const Rectangle& block, double top, double cell);

  /// Takes away what the tool sweeps on its cutting moves, in the same coordinates.
  void cut(const std::vector<Move>& moves, const Profile& profile);
  /// The greatest height within `radius` of a place; minus infinity outside of the block.
  [[nodiscard]] double highest(const Vec2& p, double radius) const;
  [[nodiscard]] const HeightMap& heights() const { return heights_; }
  HeightMap& heights() { return heights_; }

 private:
  HeightMap heights_;
};

/// The parts of paths where a tool of that radius meets material, with a little more on both ends; closed paths that meet it
/// everywhere stay closed.
std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius);

}  // namespace fieldfab::cam
