// G76: a thread on a lathe, in passes.
#pragma once

#include <functional>

namespace fieldfab::cam::gcode {

/// A thread along z. Lengths are mm.
struct Thread {
  double x = 0, start = 0, end = 0;  ///< drive line, and its ends along z
  double pitch = 0;                  ///< per revolution
  double peak = 0;                   ///< from the drive line to the thread's peak; negative: an external thread
  double first_cut = 0, full = 0;    ///< depth of the first pass and of the last
  double degression = 1;             ///< exponent by which the depths grow
  double slant = 0;                  ///< of the cuts, degrees
  double taper = 0;                  ///< length of the tapers at the ends
  int springs = 0;                   ///< further passes at the full depth
  bool entry = false, exit = false;  ///< ends with a taper
};

/// A move of the tool. The pitch of a rapid is 0.
struct ThreadMove {
  double x = 0, z = 0, pitch = 0;
};

/// Calls `give` for each move of a thread, and `count` after each pass above the full depth. Throws Refusal beyond
/// 100000 passes.
void cut_thread(const Thread& thread, const std::function<void(const ThreadMove&)>& give,
                const std::function<void()>& count);

}  // namespace fieldfab::cam::gcode
