/// Silhouette of a solid, seen along z.
#pragma once

#include "fieldfab/field/field.h"

namespace fieldfab::cam {

/// Returns a Field that is constant along z, with the least value of `solid` between the heights `low` and `high`: it
/// is negative where a vertical line meets the solid. The least value is found by branch and bound over intervals, to a
/// twentieth of itself; where intervals do not decide in time, the line counts as meeting the solid.
FieldPtr silhouette(FieldPtr solid, double low, double high);

}  // namespace fieldfab::cam
