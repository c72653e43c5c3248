/// Meshes in the form in which FreeCAD keeps them.
#pragma once

#include <string>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// The bytes of a .bms file (FreeCAD's binary mesh, version 1.0): vertices, triangles and each triangle's three neighbours, so
/// that FreeCAD reads it without looking for any of them. An edge with other than two triangles has no neighbours. Linear in the
/// size.
std::string to_bms(const TriangleMesh& mesh);

}  // namespace fieldfab
