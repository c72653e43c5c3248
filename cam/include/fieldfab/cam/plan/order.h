/// Order of paths (Keeter 6.7).
#pragma once

#include <vector>

#include "fieldfab/cam/plan/path.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// Distance travelled between paths, mm.
struct AirTravel {
  double before = 0;  ///< in the given order, from the given start points
  double after = 0;
};

struct OrderSettings {
  Vec2 start = Vec2::Zero();  ///< initial position of the tool, mm
  bool inside_first = true;   ///< paths inside a closed path precede it, so that no loose piece remains to be cut
  bool free_starts = true;    ///< whether closed paths may start at any vertex
  bool may_reverse = false;   ///< whether open paths may be reversed
};

/// Orders paths: by ascending Path::level; within a level, inner before outer ones; otherwise by nearest neighbour,
/// improved by Or-opt and 2-opt under the same constraints. O(n log n) for n evenly distributed paths. Throws
/// Error(cancelled).
AirTravel order(std::vector<Path>& paths, const OrderSettings& settings = {}, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
