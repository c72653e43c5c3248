/// Charts of the simulation report, as <svg> elements.
#pragma once

#include <string>

#include "fieldfab/cam/simulate/picture.h"

namespace fieldfab::cam {

/// Histogram of deviations in the colours of the scale: fractions of the surface area on a
/// logarithmic axis.
std::string deviation_chart(const SimulationResult& result, const DeviationScale& scale);

/// Volume removed by the program's lines, and the parts of their feed in material and in air; lines
/// with events are marked red below.
std::string lines_chart(const SimulationReport& report);

/// A colour bar, `width` by 14 pixels.
std::string colour_bar(const std::vector<Colour>& colours, int width);

}  // namespace fieldfab::cam
