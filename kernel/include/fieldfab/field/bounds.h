/// Finding the box of a solid from its Field alone.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Bounds found by interval search, with what was not bounded said plainly.
struct SolidBounds {
  Box box;               ///< holds the whole solid; tight to about 1/256 of its size; only meaningful where `bounded`
  bool bounded[3] = {};  ///< per axis: false where the solid goes on without end
  bool empty = false;    ///< the search proved that there is no solid
};

/// Searches for the smallest box that holds the solid, from Field::known_bounds() or from intervals over ever larger boxes
/// (to 1e6 mm), then shaves empty slabs from each side. Never guesses: what intervals cannot exclude stays inside the box.
SolidBounds solid_bounds(const Field& field, Progress& progress = Progress::none());

}  // namespace fieldfab
