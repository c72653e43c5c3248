/// Conversion between TriangleMesh and OpenMesh's half-edge structure. OpenMesh's headers are heavy: include this
/// header only in .cpp files.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// OpenMesh's triangle mesh with its default traits: single-precision points, mm.
using OpenTriangleMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// Converts a mesh; vertices and triangles keep their order. Throws Error(bad_input) if an edge would have three
/// triangles.
OpenTriangleMesh to_openmesh(const TriangleMesh& mesh);
/// Converts all faces that are not deleted; vertices keep their order.
TriangleMesh from_openmesh(const OpenTriangleMesh& mesh);

}  // namespace fieldfab
