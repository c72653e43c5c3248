/// The stock that a job has left, as seen from one plane: heights, for entries and to omit air cuts.
#pragma once

#include <functional>
#include <vector>

#include "fieldfab/cam/plan/path.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// Height maps of a stock in a plane's coordinates. A cell of the maps stands for all material within its square.
class Material {
 public:
  /// A full block up to height `top`, with cells of edge `cell`, mm.
  Material(const Rectangle& block, double top, double cell);
  /// A stock. `slack(cut)` is the distance, mm, by which a cut's surface may lie too high, seen from the plane.
  /// Material between cuts that is thinner than a lattice cell is seen if cuts leave their uncertainty as slack
  /// (PlannedStock).
  Material(const Stock& stock, const Plane& plane, const std::function<double(std::uint32_t cut)>& slack,
           Progress& progress = Progress::none());

  /// Returns a height that no material within `radius` of a point exceeds, mm; minus infinity where there is none.
  [[nodiscard]] double highest(const Vec2& p, double radius) const {
    return greatest(heights_, p, radius + 0.7072 * heights_.cell);
  }
  /// Returns the height up to which there certainly is material within `radius` of a point, to half a cell, mm. It is
  /// what highest() is without slack.
  [[nodiscard]] double certain(const Vec2& p, double radius) const {
    return greatest(certain_, p, radius + 0.5 * certain_.cell);
  }
  [[nodiscard]] double cell() const { return heights_.cell; }

 private:
  static double greatest(const HeightMap& map, const Vec2& p, double reach);

  HeightMap heights_, certain_;  ///< never too low; without slack
};

/// Returns the parts of paths on which a tool of that radius meets material, slightly extended at both ends. A closed
/// path that meets material everywhere stays closed.
std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius);

}  // namespace fieldfab::cam
