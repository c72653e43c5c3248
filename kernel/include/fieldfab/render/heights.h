/// Heights of a solid as numbers, for those who cut it rather than look at it.
#pragma once

#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// For each pixel of a grid of width x height over `region`, the z at which a ray from above enters the solid at the pixel's
/// centre, mm, or minus infinity; the first row has the least y. Heights are good to a thousandth of a pixel; parts thinner than
/// a pixel along z may be missed. What the top of the region cuts is met there. Throws cancelled.
std::vector<float> heights(const Field& field, const Box& region, int width, int height, Progress& progress = Progress::none());

}  // namespace fieldfab
