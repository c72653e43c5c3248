/// A contour as a path.
#pragma once

#include "fieldfab/cam/plan/operations.h"

namespace fieldfab::cam {

/// A loop as a path at z. What stays, or the wall, is on its left side unless `wall_on_left` is false: it runs so that the tool
/// climbs or not, as the settings ask.
Path loop_path(const Loop& loop, double z, const CutSettings& cut, bool wall_on_left);

}  // namespace fieldfab::cam
