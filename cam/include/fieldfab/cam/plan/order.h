/// In which order paths are cut (Keeter 6.7).
#pragma once

#include <vector>

#include "fieldfab/cam/plan/path.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// What ordering came to: how far the tool travels between paths, mm.
struct AirTravel {
  double before = 0;  ///< in the order, and from the start points, as given
  double after = 0;
};

struct OrderSettings {
  Vec2 start = Vec2::Zero();  ///< where the tool comes from
  bool inside_first =
      true;  ///< what lies inside a closed path is cut before it, so that nothing is cut loose that is still to be cut
  bool free_starts = true;   ///< closed paths may begin at any vertex
  bool may_reverse = false;  ///< open paths may be cut from either end
};

/// Puts paths in order: levels ascending (Path::level); within a level what is inside before what is outside; within that the
/// nearest next, then improved by moving and turning runs of paths (Or-opt, 2-opt) under the same rules. O(n log n) for n paths
/// spread evenly.
AirTravel order(std::vector<Path>& paths, const OrderSettings& settings = {}, Progress& progress = Progress::none());

}  // namespace fieldfab::cam
