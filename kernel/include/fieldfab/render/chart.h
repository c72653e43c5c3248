/// A chart of how often densities occur.
#pragma once

#include <cstdint>
#include <span>

#include "fieldfab/render/image.h"

namespace fieldfab {

/// Bars for the counts, from left to right, their heights by the logarithm (so that rare densities show, too), grey on white;
/// a red line at `mark`, a share of the width from 0 to 1.
Image bar_chart(std::span<const std::uint64_t> counts, double mark, int width = 1024, int height = 384);

}  // namespace fieldfab
