// Bricks of the solid of a Field.
#pragma once

#include <memory>

#include "brick.h"

namespace fieldfab::cam {

/// Makes a brick that represents a Field in a region of the stock's lattice: samples at the points, and the crossings
/// of the surface between them. NaN is outside.
std::shared_ptr<Brick> brick_of(const Field& field, const Region& region, const Stock& stock);

}  // namespace fieldfab::cam
