// The medial axis of an outline: the centres of the largest circles inside of it.
#pragma once

#include <vector>

#include "fieldfab/cam/plan/contour.h"

namespace fieldfab::cam {

/// A point of the medial axis with its distance to the outline, mm.
struct AxisPoint {
  Vec2 at;
  double radius;
};
using Branch = std::vector<AxisPoint>;

/// Returns the branches of the axis inside the outline, from fork to fork, within `tolerance`, mm. Facets of smooth
/// outlines have none. Throws Error(bad_input) for outlines beyond 20 m.
std::vector<Branch> medial_axis(const Loops& loops, double tolerance);

}  // namespace fieldfab::cam
