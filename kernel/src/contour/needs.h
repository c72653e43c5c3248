/// What it would take to show the thin parts that cells are too large for.
#pragma once

#include <span>

#include "fieldfab/field/certainty.h"

namespace fieldfab::contouring {

/// Estimates Certainty::wanted_voxel and wanted_triangles from how thick the solid, or the gap, is in some of the cells that are
/// not certain: measured along the gradient. Leaves them where nothing is found.
void estimate_needs(const Field& solid, std::span<const UncertainCell> cells, Certainty& certainty);

}  // namespace fieldfab::contouring
