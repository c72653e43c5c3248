/// Plates laid out on a sheet, to be cut from it.
#pragma once

#include <vector>

#include "fieldfab/cam/job/stage.h"

namespace fieldfab::cam {

/// Lays each part flat, its thinnest side up, and puts them side by side in rows, the tallest first, `gap` mm apart, from the
/// corner (0, 0) of a sheet of that size. The drawing of them all: a slice through the middle of each. Throws bad_input where
/// they do not fit.
Solid lay_on_sheet(const std::vector<Solid>& parts, const Vec2& sheet, double gap);

}  // namespace fieldfab::cam
