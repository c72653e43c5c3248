/// Continuous five-axis finishing: the tool inclines with the surface.
#pragma once

#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/free_space.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/surface.h"

namespace fieldfab::cam {

/// Inclination of the tool, and its distances from the part.
struct TiltSettings {
  double lead = 0;          ///< lead angle ahead of the surface normal in the direction of travel, radians
  double most = 1;          ///< greatest inclination to the plane's z, radians; below a right angle
  double clearance = 1;     ///< distance of shank and holder from the part, mm
  double tolerance = 0.01;  ///< tolerance of the cutter's side to the part, mm
};

/// Path lengths by result, mm. tilted() adds to them.
struct TiltReport {
  double leaning = 0;    ///< with the requested inclination
  double otherwise = 0;  ///< with a smaller or different inclination, to avoid contact
  double left_out = 0;   ///< omitted: shank or holder would touch the part at any inclination
};

/// Inclines the tool on finishing paths of a ball-ended tool (in plane coordinates). The centre of the ball keeps its
/// path, so that the surface stays the same. Cutter, shank and holder are clear of the part at each pose. Poses are
/// dense enough that the tool is clear between them as well (for the cutter's side up to a second-order error). Paths
/// without such a pose are omitted. Precondition: `tool` has a ball. `space` is in part coordinates. The holder extends
/// beyond its length, because the spindle is there. Throws Error(cancelled).
std::vector<Path> tilted(const std::vector<Path>& paths, const TipSurface& tips, const Tool& tool, const Plane& plane,
                         const FreeSpace& space, const TiltSettings& settings, TiltReport& report,
                         Progress& progress = Progress::none());

/// Returns the pieces of a tool above the centre of its ball, expanded by `clearance`; the holder is `beyond` mm
/// longer.
std::vector<Frustum> pieces_of(const Tool& tool, double clearance, double beyond);

}  // namespace fieldfab::cam
