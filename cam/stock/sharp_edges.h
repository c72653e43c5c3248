/// Triangles of the cubes in which surfaces meet, with vertices on their edges and corners.
#pragma once

#include "closed_mesh.h"
#include "seams.h"

namespace fieldfab::cam {

/// Completes a closed mesh with the triangles of its sharp cubes, whose corners and seams name vertices of the mesh.
/// Adds the deviations of new vertices if there is a gauge.
///
/// In the face between two cubes, the line from one vertex of the polygon to the next is replaced by two lines through
/// the seam, for both cubes. Each cube's polygon then is the rim of new triangles. The mesh stays closed, because the
/// two cubes have the same lines in their common face. It stays free of self-intersections, because the triangles of a
/// cube lie in it, meet its faces in these lines only, and are tested exactly against each other. Where no triangles
/// of a cube pass, its seams are dropped, in the cubes beside it too.
void close_sharp_cubes(const SharpCubes& sharp, const StockLattice& lattice, const DeviationGauge* gauge,
                       ClosedMesh& whole);

}  // namespace fieldfab::cam
