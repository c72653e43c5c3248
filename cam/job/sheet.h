/// Arrangement of plates on a sheet, to be cut from it.
#pragma once

#include <vector>

#include "fieldfab/cam/job/stage.h"

namespace fieldfab::cam {

/// Lays each part flat with its thinnest side upwards, and arranges the parts in rows, the tallest
/// first, `gap` mm apart and half of that from the edges of a sheet of the given size, from the corner
/// (0, 0) on. Returns the drawing of all: a slice through the middle of each. Throws Error(bad_input)
/// if they do not fit.
Solid lay_on_sheet(const std::vector<Solid>& parts, const Vec2& sheet, double gap);

}  // namespace fieldfab::cam
