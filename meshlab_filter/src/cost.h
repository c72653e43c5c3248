/// Estimates of the memory that work needs, made before it starts.
#pragma once

#include "fieldfab/core/geometry.h"

namespace fieldfab::meshlab {

/// Bytes for distances on a lattice of this spacing over a box.
double lattice_cost(const Box& bounds, double voxel);
/// Bytes for contouring that many mm2 of surface, and for the result in MeshLab: 790 per cell,
/// measured on a ball whose cells do not merge, and 400.
double surface_cost(double area, double voxel);

/// Throws too_large if contouring a solid with the surface of these bounds would take too much
/// memory.
void require_surface(const Box& bounds, double voxel);

/// Throws too_large, with the memory needed, the memory available, and a voxel that would fit, if
/// `cost` is too high. `cost` is for `voxel`, and proportional to its power `power`.
void require(double cost, double voxel, double power);

}  // namespace fieldfab::meshlab
