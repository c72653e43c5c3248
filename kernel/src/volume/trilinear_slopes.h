/// How fast trilinear interpolation between samples changes over a box; private to the volume folder.
#pragma once

#include <array>
#include <span>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// Samples on a lattice along x, y and z, x fastest. Outside of it the nearest place of it counts.
struct SampleGrid {
  const float* samples;
  std::array<int, 3> size;      ///< 2 or more along each axis
  Vec3 lower;                   ///< the first sample's place, mm
  std::array<float, 3> per_mm;  ///< 1 / spacing
};

/// Field::slopes() of the interpolation: the exact range of the directional derivatives, but for rounding. Unknown where the box
/// meets more than 16^3 cells, and where a sample there is not finite.
void trilinear_slopes(const SampleGrid& grid, const Box& box, std::span<const Vec3> directions, std::span<Interval> out) noexcept;

}  // namespace fieldfab
