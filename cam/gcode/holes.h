// Holes of the canned cycles G73, G74 and G81 to G89.
#pragma once

#include <functional>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// A hole of a canned cycle. Heights are along the plane's third axis. All lengths are mm, in program coordinates.
struct Hole {
  int code = 810;  ///< G code times ten
  ArcPlane plane = ArcPlane::xy;
  AxisValues place;           ///< position of the tool, at any height
  double r = 0, bottom = 0;   ///< heights from which and down to which the tool feeds
  double clear = 0;           ///< height to which the tool retracts
  double dwell = 0;           ///< seconds, at the bottom
  double peck = 0;            ///< depth of a peck, above 0 (G73 and G83)
  Vec2 aside = Vec2::Zero();  ///< displacement of the tool in the plane (G87)
  double end = 0;             ///< height at which boring ends (G87)
  int turning = 0;            ///< spindle before the hole: 1 clockwise, -1 anticlockwise, 0 at rest
};

/// Step of a hole.
struct HoleStep {
  enum class Kind : std::uint8_t {
    rapid,
    feed,
    dwell,    ///< of the hole's duration
    spindle,  ///< to `turning`
    stop,     ///< until the operator has drawn the tool out
  };
  Kind kind = Kind::rapid;
  AxisValues to;
  int turning = 0;
};

/// Calls `give` for each step of a hole, from the height R on, and `count` before each peck. Throws Refusal for a
/// spindle that does not turn as the cycle needs it, and beyond 1000000 pecks.
void make_hole(const Hole& hole, const std::function<void(const HoleStep&)>& give, const std::function<void()>& count);

}  // namespace fieldfab::cam::gcode
