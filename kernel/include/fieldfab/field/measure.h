/// Volume and area of a solid, with bounds that hold.
#pragma once

#include <cstddef>
#include <string>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// A number that is known to lie from `lower` to `upper`.
struct Enclosed {
  double lower = 0, upper = 0;
  [[nodiscard]] double middle() const { return 0.5 * (lower + upper); }
  [[nodiscard]] double error() const { return 0.5 * (upper - lower); }
};

struct MeasureSettings {
  double volume_accuracy = 1e-4;     ///< wanted error of the volume, as a part of it
  double area_accuracy = 0.05;       ///< of the area, which needs far more boxes
  std::size_t most_boxes = 400'000;  ///< boxes looked at before the accuracy reached has to do
};

/// What measure() found.
struct Measures {
  Enclosed volume;        ///< mm3: of the points whose value is below zero
  Enclosed area;          ///< mm2: of the surface within the bounds; `upper` is infinite where the Field's slopes prove none
  std::size_t boxes = 0;  ///< looked at
  /// For people: "volume 480 +- 0.03 mm3, area 378 +- 6 mm2".
  [[nodiscard]] std::string text() const;
};

/// Measures the part of a solid inside `bounds`, which must be finite. Boxes are halved where they leave most open. In each the
/// Field's interval, or the two planes of plane_bounds(), tell how much of it is solid at least and at most; and where the value
/// grows along a cone of directions, the surface is a graph, whose area follows from its slopes and its shadow. The same
/// result for any number of threads. Throws bad_input for bounds that are not finite, cancelled.
Measures measure(const Field& field, const Box& bounds, const MeasureSettings& settings = {},
                 Progress& progress = Progress::none());

}  // namespace fieldfab
