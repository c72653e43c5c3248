/// Fields of volumes.
#pragma once

#include "fieldfab/field/field.h"
#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// Threshold, side of the solid, and scale from density to millimetres.
struct Isosurface {
  double threshold = 0;  ///< density at the surface, in the volume's unit
  bool below = false;    ///< whether the solid has densities below the threshold
  /// Displacement of the surface per unit of density, mm: the reciprocal of the median gradient at the surface; 1 if
  /// unknown.
  double mm_per_density = 1;

  /// Converts a density to a value in mm: negative inside, 0 at the threshold, which is outside. NaN stays NaN.
  [[nodiscard]] float value(float density) const {
    const auto off = static_cast<float>((threshold - density) * mm_per_density);
    return below ? -off : off;
  }
};

/// Returns the isosurface at a threshold. Its scale is the median density gradient where the surface crosses some
/// evenly chosen slices, so that it does not depend on how the volume is read. Reads at most 64 slices. Throws
/// Error(io).
Isosurface isosurface(const Volume& volume, double threshold, bool below = false);

/// Returns the solid: values of the densities in mm, interpolated trilinearly, empty outside the lattice. The value
/// beside a NaN sample is NaN, which is outside. Copies all samples into memory, 4 bytes each; `volume` is not needed
/// afterwards. Throws Error(too_large) if they exceed it, Error(io), Error(cancelled).
FieldPtr volume_field(const Volume& volume, const Isosurface& surface, Progress& progress = Progress::none());

}  // namespace fieldfab
