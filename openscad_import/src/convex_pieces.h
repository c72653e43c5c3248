/// Decomposition of parts into convex solids.
#pragma once

#include <optional>
#include <vector>

#include "fieldfab/core/progress.h"
#include "leaf.h"

namespace fieldfab::openscad {

/// Returns convex solids whose union is the part. Differences and intersections of convex leafs are
/// cut along each other's planes, in double precision; other leafs are cut along the planes of
/// their faces. Returns nullopt if there would be very many solids, or if a leaf has many faces
/// that are not convex. Throws cancelled.
std::optional<std::vector<Polyhedron>> convex_pieces(const Part& part, Progress& progress);

}  // namespace fieldfab::openscad
