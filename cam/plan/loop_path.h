/// Conversion of a contour to a path.
#pragma once

#include "fieldfab/cam/plan/operations.h"

namespace fieldfab::cam {

/// A loop as a path at height z. The remaining material, or the wall, is on its left side unless
/// `wall_on_left` is false. The settings determine its direction (climb or conventional milling).
Path loop_path(const Loop& loop, double z, const CutSettings& cut, bool wall_on_left);

}  // namespace fieldfab::cam
