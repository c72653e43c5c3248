/// Where the surface crosses edges of a lattice.
#pragma once

#include <vector>

#include "fieldfab/field/field.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// An edge between two lattice points whose values differ in sign.
struct CrossedEdge {
  int axis;
  Eigen::Vector3f lower;  ///< its lower end, mm
  float upper;            ///< coordinate of its upper end along `axis`
  float lower_value, upper_value;
};

/// The place and the normal of the surface on each edge: to a millionth of `side`, the edges' length, or to four steps between
/// neighbouring floats (`float_step`).
void locate_crossings(const Field& field, const std::vector<CrossedEdge>& edges, double side, double float_step,
                      std::vector<SurfacePoint>& points);

}  // namespace fieldfab::contouring
