/// Bar charts of density histograms.
#pragma once

#include <cstdint>
#include <span>

#include "fieldfab/render/image.h"

namespace fieldfab {

/// Draws one bar per count from left to right, grey on white, with logarithmic heights so that rare densities remain
/// visible. A red line marks the fraction `mark` of the width, from 0 to 1. `width` and `height` are pixels.
Image bar_chart(std::span<const std::uint64_t> counts, double mark, int width = 1024, int height = 384);

}  // namespace fieldfab
