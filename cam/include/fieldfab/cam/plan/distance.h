/// Distances on a lattice (Keeter 6.3): exact, by Meijster, Roerdink and Hesselink's transform of 2000.
#pragma once

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// From each sample to the nearest solid one, mm: 0 where it is solid itself, infinity where there is none at all. Two passes
/// over the lattice, columns and rows in parallel; O(samples).
Lattice<float> distance_transform(const Bitmap& bitmap, Progress& progress = Progress::none());

/// Signed distance to the line halfway between solid samples and others: negative in the solid. Exact but for what half a cell
/// means: the edge of a bitmap is only known to lie between two samples.
Lattice<float> signed_distance(const Bitmap& bitmap, Progress& progress = Progress::none());

/// A lattice as a Field of x and y: bilinear between samples, and beyond them the nearest sample's value.
FieldPtr lattice_field(Lattice<float> lattice);

}  // namespace fieldfab::cam
