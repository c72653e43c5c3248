/// A closed triangle surface without self-intersections as a Field.
#pragma once

#include "fieldfab/field/field.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Whether each edge belongs to two triangles, once in each direction.
bool is_closed(const Polyhedron& solid);

/// Returns the exact signed distance to the surface minus `growth`, mm. The sign comes from the
/// nearest triangle, or from the pseudonormal of the nearest edge or corner (Baerentzen and Aanaes
/// 2005). That requires a closed surface without self-intersections; mesh_field() handles others.
/// It is faster than mesh_field(), and a restriction to a box keeps only the triangles near it.
FieldPtr surface_field(const Polyhedron& solid, double growth);

}  // namespace fieldfab::openscad
