/// Distances from solids whose own values are none.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// How far distances are worked out, and how finely.
struct DistanceSettings {
  double reach = 1;  ///< mm from the surface, either way; farther away the value is this, with its sign
  double voxel = 0;  ///< mm between the places where they are; 0: a 160th of the longest side
};

/// The same solid, its values signed distances in mm: what offsets, shells, blends and morphs need of a scan, whose densities are
/// distances only next to its surface. Within a voxel of the surface, and wherever the solid has parts that are thinner than a
/// voxel, the values are still its own, so that the solid does not change; within the next voxel they go over into distances.
/// These
/// are found from the crossings of the lattice's edges and followed along the surface (within some hundredths of a voxel where it
/// is smooth), then interpolated trilinearly, which cuts off ridges between parts that are equally near. `bounds` must hold the
/// solid. Memory: 16 bytes a place. Throws bad_input, too_large, cancelled.
FieldPtr distances(FieldPtr solid, const Box& bounds, const DistanceSettings& settings, Progress& progress = Progress::none());

}  // namespace fieldfab
