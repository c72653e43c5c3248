/// Bounding box of a solid, found from its Field alone.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Result of the search for a bounding box.
struct SolidBounds {
  Box box;               ///< contains the whole solid, to about 1/256 of its size; valid only on bounded axes
  bool bounded[3] = {};  ///< per axis (x, y, z): false if the solid is unbounded along it, as far as intervals show
  bool empty = false;    ///< whether the search proved that the solid is empty
  [[nodiscard]] bool is_bounded() const { return bounded[0] && bounded[1] && bounded[2]; }
};

/// Searches for the smallest box that contains the solid. Starts from Field::known_bounds(), or from boxes up to 1e6 mm
/// from the origin, and removes slabs that intervals prove to be empty. If that fails in x, y and z, repeats the search
/// in the coordinates of Field::framed(). The result is conservative: whatever intervals cannot exclude remains in the
/// box, also where the value may be NaN. The Field keeps the result. Throws Error(cancelled).
SolidBounds solid_bounds(const Field& field, Progress& progress = Progress::none());

/// Moves each face of a box that contains a solid inwards, as near to the solid as intervals show with a limited number
/// of boxes: flat faces to about 1e-7 of the box's size, round ones to some thousandths of a per cent. The result still
/// contains the solid. Axes of size 0 are left as they are. Throws Error(cancelled).
Box tight_bounds(const Field& field, const Box& bounds, Progress& progress = Progress::none());

}  // namespace fieldfab
