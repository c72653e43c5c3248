/// Fits a valid mesh to the sharp edges and corners that its cells cut off.
#pragma once

#include <span>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::contouring {

/// Moves vertices, flips edges and divides edges and triangles near the triangles `creased`, until
/// the mesh there is within `tolerance` mm of the solid's surface or no step improves it. Each step
/// brings the mesh closer and is made only if the mesh stays valid (mesh_editor.h). `voxel` is the
/// size of the smallest cells, mm. Throws cancelled.
void sharpen(const Field& solid, double voxel, double tolerance, std::span<const std::uint32_t> creased,
             TriangleMesh& mesh, Progress& progress);

}  // namespace fieldfab::contouring
