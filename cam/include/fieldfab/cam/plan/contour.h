/// Contours of a Field in a plane (Keeter 6.4), and distances to them (6.5 without a lattice).
#pragma once

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// What to contour.
struct ContourSettings {
  double cell = 0.1;  ///< edge of the squares, mm: what is narrower may be missed
  double z = 0;       ///< the plane
  double level = 0;   ///< the value that counts as the surface
};

/// What contours() may have missed between its samples.
struct MissedParts {
  std::size_t lost = 0;       ///< squares whose corners do not show what is found within
  std::size_t unproved = 0;   ///< squares in which it is not proved that there is nothing
  Vec2 place = Vec2::Zero();  ///< one of them, the lost ones first
  [[nodiscard]] bool any() const { return lost + unproved > 0; }
};

/// Marching squares over a quadtree whose squares are left out where the Field's interval tells that no contour passes: time and
/// memory grow with the length of the contour, not with the area. Points lie on the contour to a thousandth of a cell; corners
/// are met where two tangents do. What reaches beyond `region` is closed along its border. Same result for any number of threads.
/// Throws bad_input for a cell or region that is not positive and finite, too_large, cancelled.
Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings,
               Progress& progress = Progress::none());
/// The same, and whether parts narrower than a square were missed: squares with all corners on one side are looked into, down to
/// a 16th of a cell, by the Field's intervals and slopes. Of a Field that tells no slopes only what is found is counted.
Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings, MissedParts& missed,
               Progress& progress = Progress::none());

/// Signed distance to closed curves as a Field of x and y, exact: negative where the loops have their left side. Its contours are
/// offsets of the loops: outward for levels above 0. A value costs O(log segments).
FieldPtr outline_field(const Loops& loops);

/// The loops moved outward by `distance` (inward where negative): the boundary of the Minkowski sum with a disc, and of what a
/// disc cannot reach. The squares are at most `cell` wide.
Loops offset(const Loops& loops, double distance, double cell, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
