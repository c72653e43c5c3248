/// Signed distances of points from a solid's surface, for Fields of any scale.
#pragma once

#include <array>
#include <span>

#include "fieldfab/field/field.h"

namespace fieldfab {

/// Magnitude returned for points farther than this, or without a surface found nearby, mm.
inline constexpr float far_from_surface = 10;

/// Writes the signed distance of each point from the surface, mm, negative inside. `distances` has one entry per place.
/// The result is exact if the Field is a distance, and of second order near the surface of a smooth Field. If values
/// are not distances (fillets, noise between samples), a depth inside is overestimated by at most half, and never
/// underestimated. Runs in parallel; the result does not depend on the number of threads.
void surface_distances(const Field& solid, std::span<const std::array<float, 3>> places, std::span<float> distances);

}  // namespace fieldfab
