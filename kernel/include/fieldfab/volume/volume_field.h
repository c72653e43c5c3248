/// A volume as a solid.
#pragma once

#include "fieldfab/field/field.h"
#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// Which side of a threshold is solid, and how densities become millimetres.
struct Isosurface {
  double threshold = 0;
  bool below = false;  ///< solid is what is less dense
  /// mm by which the surface moves for one unit of density: 1 / the usual steepness at the surface, or 1 where nothing is known.
  double mm_per_density = 1;

  /// Negative inside, in mm near the surface; what is exactly at the threshold is outside.
  [[nodiscard]] float value(float density) const {
    const auto off = static_cast<float>((threshold - density) * mm_per_density);
    return below ? -off : off;
  }
};

/// The isosurface at a threshold with its scale: the median steepness of the density where the surface crosses some of the
/// slices, evenly chosen, so that the answer does not depend on how a volume is read.
Isosurface isosurface(const Volume& volume, double threshold, bool below = false);

/// The solid: densities interpolated trilinearly between samples, empty outside of the lattice. Keeps all samples in memory, 4
/// bytes each: throws too_large where that is not there.
FieldPtr volume_field(const Volume& volume, const Isosurface& surface, Progress& progress = Progress::none());

}  // namespace fieldfab
