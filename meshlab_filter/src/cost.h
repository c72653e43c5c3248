/// What work takes, before it is begun.
#pragma once

#include "fieldfab/core/geometry.h"

namespace fieldfab::meshlab {

/// Bytes that distances on a lattice of this spacing take over a box.
double lattice_cost(const Box& bounds, double voxel);
/// Bytes that contouring takes for so many mm2 of surface, and MeshLab for the result: 790 a cell for a ball whose cells do not
/// merge, as measured, and 400.
double surface_cost(double area, double voxel);

/// Throws too_large where contouring a solid that fills these bounds, as a box does, would take too much memory.
void require_surface(const Box& bounds, double voxel);

/// Throws too_large with what it would take, what there is, and a voxel that would fit: `cost` is for `voxel`, and goes with its
/// `power`.
void require(double cost, double voxel, double power);

}  // namespace fieldfab::meshlab
