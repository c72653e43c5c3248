/// Exact distance transforms on a lattice (Keeter 6.3), by the algorithm of Meijster, Roerdink and Hesselink (2000).
#pragma once

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// Returns the distance from each sample to the nearest solid sample, mm: 0 at solid samples, infinity if there are
/// none. Two passes, by columns and by rows, in parallel. O(samples). Throws Error(cancelled).
Lattice<float> distance_transform(const Bitmap& bitmap, Progress& progress = Progress::none());

/// Returns the signed distance to the line halfway between solid and other samples, mm, negative in the solid. The edge
/// of a bitmap is only known to half a cell; the result is exact otherwise. Throws Error(cancelled).
Lattice<float> signed_distance(const Bitmap& bitmap, Progress& progress = Progress::none());

/// Returns a lattice as a Field of x and y: bilinear between samples, constant beyond the outermost ones.
FieldPtr lattice_field(Lattice<float> lattice);

}  // namespace fieldfab::cam
