/// Volume and surface area of a solid, with guaranteed bounds.
#pragma once

#include <cstddef>
#include <string>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// A number known to lie between `lower` and `upper`.
struct Enclosed {
  double lower = 0, upper = 0;
  [[nodiscard]] double middle() const { return 0.5 * (lower + upper); }
  [[nodiscard]] double error() const { return 0.5 * (upper - lower); }
};

/// Wanted accuracy and limit of effort.
struct MeasureSettings {
  double volume_accuracy = 1e-4;     ///< relative error wanted for the volume
  double area_accuracy = 0.05;       ///< relative error wanted for the area, which needs far more boxes
  std::size_t most_boxes = 400'000;  ///< maximum number of boxes; beyond it the accuracy reached is returned
};

/// Result of measure().
struct Measures {
  Enclosed volume;  ///< volume of the points with a negative value, mm^3
  /// area of the surface within the bounds, mm^2; `upper` is infinite if the Field's slopes prove no bound
  Enclosed area;
  std::size_t boxes = 0;  ///< number of boxes examined
  /// Returns a text for people: "volume 480 +- 0.03 mm3, area 378 +- 6 mm2".
  [[nodiscard]] std::string text() const;
};

/// Measures the part of a solid inside `bounds`. Subdivides the boxes with the greatest uncertainty. In each box the
/// Field's interval, or the two planes of plane_bounds(), bound the solid fraction from both sides. Where the value
/// increases along a cone of directions, the surface is a graph; its area follows from its slopes and its projection.
/// The result does not depend on the number of threads. Throws Error(bad_input) unless `bounds` is finite,
/// Error(cancelled).
Measures measure(const Field& field, const Box& bounds, const MeasureSettings& settings = {},
                 Progress& progress = Progress::none());

}  // namespace fieldfab
