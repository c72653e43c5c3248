/// Distance fields of solids whose values are not distances.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// Extent and resolution of the distances.
struct DistanceSettings {
  double reach = 1;  ///< distance from the surface, on both sides, beyond which the magnitude is constant, mm
  double voxel = 0;  ///< spacing of the lattice, mm; 0: a 160th of the longest side
};

/// Returns the same solid with signed distances in mm as values. Offsets, shells, blends and morphs of a scan need
/// them, because densities are distances only next to the surface.
/// - Within a voxel of the surface, and in parts thinner than a voxel, the values remain those of `solid`, so that the
///   surface does not move. Within the next voxel they change smoothly to distances.
/// - Distances are computed from the crossings of lattice edges, propagated along the surface (error: some hundredths
///   of a voxel for a smooth surface), and interpolated trilinearly, which rounds ridges between equally near parts.
/// - `bounds` must contain the solid.
/// Memory: 16 bytes per lattice point. Throws Error(bad_input), Error(too_large), Error(cancelled).
FieldPtr distances(FieldPtr solid, const Box& bounds, const DistanceSettings& settings,
                   Progress& progress = Progress::none());

}  // namespace fieldfab
