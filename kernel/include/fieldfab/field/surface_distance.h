/// How far places are from a solid's surface, whatever its values mean.
#pragma once

#include <array>
#include <span>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// What surface_distances() tells of places that are farther than this, or whose nearest surface was not found, mm.
inline constexpr float far_from_surface = 10;

/// Writes the signed distance of each place, mm, below 0 inside: exact where the Field is a distance, of second order near the
/// surface of any smooth one. Where values are no distances (fillets, noise between samples) depths inside are at most half as
/// much too large; none is too small. `distances` has one place for each. In parallel; the result does not depend on threads.
void surface_distances(const Field& solid, std::span<const std::array<float, 3>> places, std::span<float> distances);

}  // namespace fieldfab
