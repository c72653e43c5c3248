/// Flat shapes, extruded and turned, as Fields.
#pragma once

#include "fieldfab/field/field.h"
#include "flat.h"

namespace fieldfab::openscad {

/// A flat shape from z = lower to z = upper, grown by `growth` mm: the exact distance.
FieldPtr extruded_field(const Region& region, double lower, double upper, double growth);
/// The same without ends along z.
FieldPtr flat_field(const Region& region, double growth);

/// How a profile is turned about z.
struct Turn {
  int fragments = 0;  ///< straight sides of the full or partial turn; 0: it is round
  double first = 0;   ///< radians: where the first side begins
  double step = 0;    ///< radians a side
};
/// A profile (x, z), symmetric in x, turned about z and grown by `growth` mm: a lower bound of the distance, exact where it is
/// round. A partial turn goes on beyond its ends as its first and last side do; it is for the caller to cut it.
FieldPtr turned_field(const Region& symmetric_profile, const Turn& turn, double growth);

}  // namespace fieldfab::openscad
