#pragma once

#include <optional>
#include <string>

#include "fieldfab/core/geometry.h"

namespace fieldfab::meshlab {

/// Parses "x0,y0,z0,x1,y1,z1" in mm; nullopt for an empty text. Throws bad_input.
std::optional<Box> bounds_of(const std::string& text);

}  // namespace fieldfab::meshlab
