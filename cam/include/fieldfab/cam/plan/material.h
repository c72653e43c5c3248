/// The stock that a job has left, as seen from one plane: heights, for entries and to omit air cuts.
#pragma once

#include <functional>
#include <vector>

#include "fieldfab/cam/base/tool.h"
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
  /// (PlannedStock); `whole` says that there is none.
  Material(const Stock& stock, const Plane& plane, const std::function<double(std::uint32_t cut)>& slack, bool whole,
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
  /// Whether a vertical cutter may meet material that is higher than its surface by more than `least` mm. Never false
  /// where it does, if whole().
  [[nodiscard]] bool may_meet(const Vec3& tip, const Profile& cutter, double least) const;
  /// Whether the heights miss no material at all.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] double cell() const { return heights_.cell; }

 private:
  static double greatest(const HeightMap& map, const Vec2& p, double reach);

  HeightMap heights_, certain_;  ///< never too low; without slack
  bool whole_ = true;
};

/// Returns the parts of paths on which a tool of that radius meets material, slightly extended at both ends. A closed
/// path that meets material everywhere stays closed.
std::vector<Path> where_material(const std::vector<Path>& paths, const Material& material, double radius);
/// Returns paths along a surface without the parts on which the cutter is surely in the air: no material stands more
/// than `tolerance` mm above the cutter's surface. They are extended at both ends. Unchanged if material may be missed.
std::vector<Path> without_air(const std::vector<Path>& paths, const Material& material, const Profile& cutter,
                              double tolerance);

}  // namespace fieldfab::cam
