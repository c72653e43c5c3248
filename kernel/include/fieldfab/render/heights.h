/// Height maps as numbers, for machining.
#pragma once

#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Returns, for each pixel of a width x height grid over `region`, the z in mm at which a vertical ray from above
/// enters the solid at the pixel's centre; minus infinity if it misses. Row 0 has the least y. Heights are accurate to
/// a thousandth of a pixel. Parts thinner than a pixel along z may be missed. A solid that extends above the region is
/// cut at its top. Throws Error(cancelled).
std::vector<float> heights(const Field& field, const Box& region, int width, int height,
                           Progress& progress = Progress::none());

}  // namespace fieldfab
