/// Rate of change of trilinear interpolation over a box; private to the volume folder.
#pragma once

#include <array>
#include <span>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// Samples on a lattice along x, y and z, x fastest. A point outside gets the value of the nearest
/// point of the lattice.
struct SampleGrid {
  const float* samples;
  std::array<int, 3> size;      ///< at least 2 along each axis
  Vec3 lower;                   ///< position of the first sample, mm
  std::array<float, 3> per_mm;  ///< 1 / spacing, per mm
};

/// Field::slopes() of the interpolation: the exact range of the directional derivatives, except for
/// rounding. Unknown if the box meets more than 16^3 cells, or if a sample there is not finite.
void trilinear_slopes(const SampleGrid& grid, const Box& box, std::span<const Vec3> directions,
                      std::span<Interval> out) noexcept;

}  // namespace fieldfab
