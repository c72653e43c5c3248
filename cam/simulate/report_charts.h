/// The charts of the report on a simulation, as <svg> elements.
#pragma once

#include <string>

#include "fieldfab/cam/simulate/picture.h"

namespace fieldfab::cam {

/// How much of the surface deviates how far, in the colours of the scale; shares of the area, logarithmic.
std::string deviation_chart(const SimulationResult& result, const DeviationScale& scale);

/// What the program's lines remove, and how much of their feed goes through material and through air; red below them: where
/// something is wrong.
std::string lines_chart(const SimulationReport& report);

/// A sequence of colours as a bar, `width` by 14 pixels.
std::string colour_bar(const std::vector<Colour>& colours, int width);

}  // namespace fieldfab::cam
