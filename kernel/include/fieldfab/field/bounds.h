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
  [[nodiscard]] bool is_bounded() const { return bounded[0] && bounded[1] && bounded[2]; }
};

/// Searches for the smallest box that holds the solid, from Field::known_bounds() or from intervals over boxes as far
/// as 1e6 mm, shaving off empty slabs from each side; where that fails in x, y and z it is tried in Field::framed(). Never
/// guesses: what intervals cannot exclude stays inside the box.
SolidBounds solid_bounds(const Field& field, Progress& progress = Progress::none());

}  // namespace fieldfab
