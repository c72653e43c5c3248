/// Extruded and rotated flat shapes as Fields.
#pragma once

#include "fieldfab/field/field.h"
#include "flat.h"

namespace fieldfab::openscad {

/// Returns the exact distance to a flat shape from z = lower to z = upper, grown by `growth` mm.
FieldPtr extruded_field(const Region& region, double lower, double upper, double growth);
/// Returns the exact distance to the unbounded extrusion of a flat shape along z.
FieldPtr flat_field(const Region& region, double growth);

/// Rotation of a profile about z.
struct Turn {
  int fragments = 0;  ///< number of flat sides of the full or partial turn; 0: round
  double first = 0;   ///< start angle of the first side, radians
  double step = 0;    ///< radians per side
};
/// Rotates a profile (x, z), symmetric in x, about z and grows it by `growth` mm. The value is a
/// lower bound of the distance, and exact if round. A partial turn continues beyond its ends like
/// its first and last side; the caller must cut it.
FieldPtr turned_field(const Region& symmetric_profile, const Turn& turn, double growth);

}  // namespace fieldfab::openscad
