/// Tools that are too short for a cut (Keeter 6.9): how far they go, and what stays.
#pragma once

#include <vector>

#include "fieldfab/cam/plan/planned_stock.h"

namespace fieldfab::cam {

/// Cuts a stock as PlannedStock::back_out() does. `cut` is the number that samples store.
std::vector<Move> back_out(Stock& stock, std::uint32_t cut, const std::vector<Move>& moves, const Tool& tool,
                           const Plane& plane, double plunge, BackedOut& report, Progress& progress);

}  // namespace fieldfab::cam
