/// Silhouette of a solid, seen along z.
#pragma once

#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// Returns a Field that is constant along z, with the least value of `solid` between the heights `low` and `high`: it
/// is negative where a vertical line meets the solid. The least value is found by branch and bound over intervals, to a
/// twentieth of itself; where intervals do not decide in time, the line counts as meeting the solid.
FieldPtr silhouette(FieldPtr solid, double low, double high);

/// Whether intervals find the least values of this solid in few steps, as those of formulas of distances do; tried on a
/// lattice of lines. Single values of meshes, ASDFs and scans are slow, and wide intervals need many steps.
bool has_quick_silhouette(const FieldPtr& solid, const Box& bounds);

}  // namespace fieldfab::cam
