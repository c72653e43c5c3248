/// Parts of a solid that a lattice of heights does not show: ribs and pins between its samples.
#pragma once

#include <functional>

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// A square of a lattice, by its lower left sample, above whose samples something of the solid may stand.
struct SuspectSquare {
  int column, row;
  FieldPtr field;  ///< good over the square, within the bounds from its lowest sample on
  bool slopes;     ///< whether it tells its slopes: then what stands there is found, however thin
};

/// Searches for what stands between the samples of a lattice, from the heights sampled up to the top of a box.
class HiddenParts {
 public:
  /// Of the solid only what is in `bounds` counts. `slack`: how far, in mm, the solid may rise above the plane of the samples
  /// nearby. Where the Field does not tell its slopes, only what rises `coarse_slack` mm above the highest sample of its square
  /// is found.
  HiddenParts(const Box& bounds, double slack, double coarse_slack)
      : bounds_(bounds), slack_(slack), coarse_slack_(coarse_slack) {}

  /// Calls visit() for each square of those from sample (left, low) to (right, high) where neither an interval nor the planes of
  /// plane_bounds() prove that the samples show all there is.
  void search(const Field& field, const HeightMap& heights, int left, int low, int right, int high,
              const std::function<void(const SuspectSquare&)>& visit) const;

  /// What of the bounds is over the samples from (left, low) to (right, high), from z on; not valid() where there is nothing.
  [[nodiscard]] Box above(const HeightMap& heights, int left, int low, int right, int high, double z) const;

  /// How high the solid reaches in a box.
  struct Top {
    double z;   ///< nothing of it is higher; minus infinity where it is not in the box
    bool sure;  ///< whether it is proved to be there
  };
  [[nodiscard]] static Top highest(const Field& field, const Box& box);

 private:
  Box bounds_;
  double slack_, coarse_slack_;
};

}  // namespace fieldfab::cam
