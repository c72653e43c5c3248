/// Estimate of the voxel that would resolve the thin parts of a solid.
#pragma once

#include <span>

#include "fieldfab/field/certainty.h"

namespace fieldfab::contouring {

/// Estimates Certainty::wanted_voxel and wanted_triangles from the thickness of the solid, or of
/// the gap, in some of the uncertain cells, measured along the gradient. Leaves them unchanged if
/// no thickness is found.
void estimate_needs(const Field& solid, std::span<const UncertainCell> cells, Certainty& certainty);

}  // namespace fieldfab::contouring
