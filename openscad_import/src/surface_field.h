/// A closed surface of triangles that does not cross itself, as a Field.
#pragma once

#include "fieldfab/field/field.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Whether each edge belongs to two triangles, once each way.
bool is_closed(const Polyhedron& solid);

/// The exact signed distance to the surface less `growth`, mm. The side is told by the nearest triangle, or by the mean normal of
/// the nearest edge or corner (Baerentzen and Aanaes 2005), which only holds for a surface that is closed and does not cross
/// itself; for others there is mesh_field(). It is quicker than that, and in a box only what is near is looked at.
FieldPtr surface_field(const Polyhedron& solid, double growth);

}  // namespace fieldfab::openscad
