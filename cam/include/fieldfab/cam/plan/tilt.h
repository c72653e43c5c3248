/// Continuous five-axis finishing: the tool leans along with the surface.
#pragma once

#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/free_space.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/surface.h"

namespace fieldfab::cam {

struct TiltSettings {
  double lead = 0;          ///< leans ahead of the surface's normal, in the direction of travel, radians
  double most = 1;          ///< against the plane's z, radians; below a right angle
  double clearance = 1;     ///< of shank and holder from the part, mm
  double tolerance = 0.01;  ///< of the cutter's side against the part, mm
};

/// What became of the wish to follow the normal, mm of path.
struct TiltReport {
  double leaning = 0;    ///< as asked for
  double otherwise = 0;  ///< less far or elsewhere, so that nothing touches
  double left_out = 0;   ///< where shank or holder would touch the part at any tilt
};

/// Turns finishing paths of a ball-ended tool that points straight down (in a plane's coordinates) into ones where it leans: the
/// ball's middle stays where it was, so that the surface comes out the same; cutter, shank and holder are clear of the part at
/// every pose, and poses are so close that they are between them, too (but for the cutter's side, second-order small). Where
/// there is no such pose, paths are left out. `space` is the part's, in its own coordinates. The holder goes on beyond its
/// length: the spindle is there.
std::vector<Path> tilted(const std::vector<Path>& paths, const TipSurface& tips, const Tool& tool, const Plane& plane,
                         const FreeSpace& space, const TiltSettings& settings, TiltReport& report,
                         Progress& progress = Progress::none());

/// The pieces of a tool above the middle of its ball.
std::vector<Frustum> pieces_of(const Tool& tool, double clearance, double beyond);

}  // namespace fieldfab::cam
