/// Parts of a solid between the samples of a height lattice: ribs and pins.
#pragma once

#include <functional>

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// A square of a lattice, by its lower left sample, in which the solid may rise above the samples.
struct SuspectSquare {
  int column, row;
  double top;      ///< height above which the solid does not rise there
  FieldPtr field;  ///< valid over the square, within the bounds, from its lowest sample up to `top`
  bool slopes;     ///< whether it has slopes: then all parts are found, however thin
};

/// Searches for parts between the samples of a lattice, from the sampled heights to the top of a
/// box.
class HiddenParts {
 public:
  /// Only the part of the solid in `bounds` counts. `slack`: height by which the solid may rise
  /// above the plane of nearby samples, mm. For a Field without slopes, only parts that rise more
  /// than `coarse_slack` mm above the highest sample of their square are found.
  HiddenParts(const Box& bounds, double slack, double coarse_slack)
      : bounds_(bounds), slack_(slack), coarse_slack_(coarse_slack) {}

  /// Calls visit() for each square between the samples (left, low) and (right, high) for which
  /// neither an interval nor plane_bounds() proves that the samples represent the solid.
  void search(const Field& field, const HeightMap& heights, int left, int low, int right, int high,
              const std::function<void(const SuspectSquare&)>& visit) const;

  /// Greatest height of the solid in a square. Of little use without slopes, where intervals are too loose.
  struct Top {
    double z;   ///< upper bound; minus infinity if the solid rises nowhere above the samples by more than `slack`
    bool sure;  ///< whether a part of the solid there is proved
  };
  [[nodiscard]] Top highest(const HeightMap& heights, const SuspectSquare& square) const;

 private:
  /// Searches below `top`.
  void search(const Field& field, const HeightMap& heights, int left, int low, int right, int high, double top,
              const std::function<void(const SuspectSquare&)>& visit) const;
  /// Part of the bounds over the samples (left, low) to (right, high), from height `z` up to `top`; not valid() if
  /// empty.
  [[nodiscard]] Box above(const HeightMap& heights, int left, int low, int right, int high, double z, double top) const;

  Box bounds_;
  double slack_, coarse_slack_;
};

}  // namespace fieldfab::cam
