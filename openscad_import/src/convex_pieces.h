/// Parts cut into convex solids.
#pragma once

#include <optional>
#include <vector>

#include "fieldfab/core/progress.h"
#include "leaf.h"

namespace fieldfab::openscad {

/// Convex solids whose union a part is. Of differences and intersections of convex ones by cutting these along each other's
/// planes, in double precision; other leafs are cut along the planes of their faces. Nothing where there would be very many, or
/// where a leaf has many faces that are not convex. Throws cancelled.
std::optional<std::vector<Polyhedron>> convex_pieces(const Part& part, Progress& progress);

}  // namespace fieldfab::openscad
