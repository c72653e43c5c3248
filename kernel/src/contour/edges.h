/// Intersections of the surface with edges of a lattice.
#pragma once

#include <vector>

#include "fieldfab/field/field.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// An edge between two lattice points whose values differ in sign.
struct CrossedEdge {
  int axis;
  Eigen::Vector3f lower;  ///< its lower end, mm
  float upper;            ///< coordinate of its upper end along `axis`, mm
  float lower_value, upper_value;
};

/// Computes position and normal of the surface on each edge. The error is at most `side` (the
/// length of the edges) / 1e6, or four steps between neighbouring floats (`float_step`).
void locate_crossings(const Field& field, const std::vector<CrossedEdge>& edges, double side, double float_step,
                      std::vector<SurfacePoint>& points);

}  // namespace fieldfab::contouring
