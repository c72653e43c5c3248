/// A TriangleMesh as an OpenMesh, for those who want its half-edges. OpenMesh's headers are heavy: include this only in .cpp
/// files.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// OpenMesh's triangle mesh with its default traits: single-precision points, in mm.
using OpenTriangleMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// The same vertices and triangles, in the same order. Throws bad_input where a triangle would make an edge belong to three.
OpenTriangleMesh to_openmesh(const TriangleMesh& mesh);
/// The faces that are not deleted; vertices keep their order.
TriangleMesh from_openmesh(const OpenTriangleMesh& mesh);

}  // namespace fieldfab
