/// Many solids as one Field.
#pragma once

#include <vector>

#include "fieldfab/field/field.h"

namespace fieldfab::openscad {

/// A solid and its position.
struct Placed {
  FieldPtr field;
  Box box;  ///< contains the solid
  /// Outside the box the value is at least this factor times the distance to the box along the
  /// farthest axis.
  double steepness;
};

/// Returns the union of all parts: the minimum of their values, as by unite(). Parts that cannot
/// matter for a batch of points or in a box are not evaluated.
FieldPtr assembly(std::vector<Placed> parts);

}  // namespace fieldfab::openscad
