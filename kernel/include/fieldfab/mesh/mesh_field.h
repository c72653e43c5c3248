/// A triangle mesh as a solid.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// The signed distance to the mesh's triangles, mm: exact, by a tree of boxes. What the triangles wind around is inside, by the
/// generalised winding number (Jacobson et al. 2013, with the hierarchy of Barill et al. 2018): for a closed mesh that is what it
/// encloses; holes are closed by the surface on which half of the view is triangles, where values jump from one side to the other
/// (Lids of mesh_distances.h are surface, too); overlaps are inside once; a mesh that is inside out is the same solid. Throws
/// bad_input for a mesh without triangles, or with numbers that are not finite.
FieldPtr mesh_field(const TriangleMesh& mesh, Progress& progress = Progress::none());

/// The mesh that a Field of mesh_field() was made from, where it is closed; nullptr for any other Field. It lives as long as the
/// Field does.
const TriangleMesh* closed_mesh_of(const Field& field);

}  // namespace fieldfab
