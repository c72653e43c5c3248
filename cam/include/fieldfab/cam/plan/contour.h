/// Contours of a Field in a plane (Keeter 6.4), and distances to them (6.5, without a lattice).
#pragma once

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// Parameters of a contour.
struct ContourSettings {
  double cell = 0.1;  ///< edge of the squares, mm; narrower parts may be missed
  double z = 0;       ///< height of the plane, mm
  double level = 0;   ///< value of the contour
};

/// Parts that contours() may have missed between its samples.
struct MissedParts {
  std::size_t lost = 0;       ///< number of squares with a detected part that their corners do not show
  std::size_t unproved = 0;   ///< number of squares for which the absence of a part is not proved
  Vec2 place = Vec2::Zero();  ///< a point in one of these squares, preferably one with a detected part, mm
  [[nodiscard]] bool any() const { return lost + unproved > 0; }
};

/// Extracts contours by marching squares over a quadtree. Squares whose interval excludes a contour are skipped: time
/// and memory are proportional to the length of the contour. Vertices lie on the contour to a thousandth of a cell; a
/// corner is placed at the intersection of two tangents. Contours are closed along the border of `region`. NaN is
/// outside. The result does not depend on the number of threads. Throws Error(bad_input) for a cell or region that is
/// not positive and finite, Error(too_large), Error(cancelled).
Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings,
               Progress& progress = Progress::none());
/// Extracts contours and reports missed parts: searches squares whose corners all lie on one side, down to a 16th of a
/// cell, by the Field's intervals and slopes. For a Field without bounds of its slopes, only detected parts are
/// counted.
Loops contours(const Field& field, const Rectangle& region, const ContourSettings& settings, MissedParts& missed,
               Progress& progress = Progress::none());

/// Returns the exact signed distance to closed curves as a Field of x and y, mm: negative on the left of the loops. Its
/// contours are offsets of the loops, outward for positive levels. Copies the loops. O(log segments) per value.
FieldPtr outline_field(const Loops& loops);

/// Offsets loops by `distance` mm, outward if positive: the boundary of the Minkowski sum with a disc, or of the
/// complement of such a sum. `cell` bounds the edge of the squares, mm. Throws as contours().
Loops offset(const Loops& loops, double distance, double cell, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
