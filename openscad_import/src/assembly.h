/// Many solids as one Field.
#pragma once

#include <vector>

#include "fieldfab/field/field.h"

namespace fieldfab::openscad {

/// A solid, and where it is.
struct Placed {
  FieldPtr field;
  Box box;           ///< holds it
  double steepness;  ///< outside of the box the value is at least so many times the distance to the box along the farthest axis
};

/// The union of all: the least of their values, as unite() gives it; but what cannot matter for a batch of points, or in a box,
/// is not asked.
FieldPtr assembly(std::vector<Placed> parts);

}  // namespace fieldfab::openscad
