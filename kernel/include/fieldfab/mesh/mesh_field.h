/// Fields of triangle meshes.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Returns the signed distance to the triangles, mm, exact by a bounding volume hierarchy. The inside is determined by
/// the generalised winding number (Jacobson et al. 2013; hierarchy of Barill et al. 2018).
/// - For a closed mesh it is the enclosed volume, also with inverted orientation; overlaps count once.
/// - A hole is closed by the surface on which the winding number is 1/2. The value jumps there from one sign to the
///   other, because the distance refers to triangles only. Lids (mesh_distances.h) avoid this: they are triangles, too.
/// - The value is NaN at a point with NaN or infinite coordinates.
/// Copies the mesh. Throws Error(bad_input) for a mesh without triangles or without area, or with coordinates that are
/// not finite; Error(cancelled).
FieldPtr mesh_field(const TriangleMesh& mesh, Progress& progress = Progress::none());

/// Returns the closed mesh of a Field made by mesh_field(), owned by the Field; nullptr for an open mesh or another
/// Field.
const TriangleMesh* closed_mesh_of(const Field& field);

}  // namespace fieldfab
