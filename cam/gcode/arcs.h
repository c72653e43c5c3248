// Circles of arcs, from the words of a block.
#pragma once

#include "control.h"

namespace fieldfab::cam::gcode {

/// Circle of an arc in its plane.
struct Circle {
  Vec2 centre = Vec2::Zero();
  int turns = 1;  ///< as Motion::turns
};

/// Returns the circle of a block with G2 (`direction` -1) or G3 (1), from I, J, K or R, and P. `from` and `to` are the
/// arc's ends in the plane, mm. Throws Refusal for words that give no circle through both ends, within LinuxCNC's
/// tolerances.
Circle circle_of(const Block& block, const Modes& modes, int direction, const Vec2& from, const Vec2& to);

/// Removes the words of an arc that controls other than LinuxCNC's ignore: the offset across the plane (posts write
/// K0 in the XY plane), and offsets beside R. Returns a note for those that are not 0, or an empty string.
std::string without_idle_offsets(Block& block, const Modes& modes);

}  // namespace fieldfab::cam::gcode
