/// Meshes in FreeCAD's binary format.
#pragma once

#include <string>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Returns the bytes of a .bms file (FreeCAD's binary mesh, version 1.0): vertices, triangles and the three neighbours
/// of each triangle, so that FreeCAD need not search for them. An edge with a number of triangles other than two has no
/// neighbours. Linear in the size of the mesh.
std::string to_bms(const TriangleMesh& mesh);

}  // namespace fieldfab
