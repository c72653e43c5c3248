// G76: a thread on a lathe, in passes.
#include <cmath>

#include "fieldfab/core/angle.h"
#include "interpreter.h"

namespace fieldfab::cam::gcode {

void Interpreter::thread() {
  no_compensation("G76");
  for (const char letter : {'p', 'z', 'i', 'j', 'k'})
    if (!block_.has(letter)) refuse("G76 needs {}", static_cast<char>(letter - 32));
  if (block_.has_any("xyabcuvw")) refuse("G76 takes no axis word but Z");
  if (modes_.spindle == 0 || modes_.speed == 0) refuse("G76 while the spindle stands still");
  const double half = modes_.diameter ? 0.5 : 1;  // I, J and K are diameters under G7
  const double pitch = length(block_['p']), peak = length(block_['i']) * half, first_cut = length(block_['j']) * half,
               full = length(block_['k']) * half;
  const double degression = block_.has('r') ? block_['r'] : 1, slant = block_.has('q') ? block_['q'] : 0;
  const double taper = block_.has('e') ? length(block_['e']) : 0;
  const int springs = block_.has('h') ? whole(block_['h'], 10'000) : 0, ends = block_.has('l') ? whole(block_['l']) : 0;
  if (pitch <= 0 || peak == 0 || first_cut <= 0) refuse("G76 needs P and J above 0, and I other than 0");
  if (full <= first_cut) refuse("G76: K, the full depth, must be more than J, the first cut's");
  if (degression < 1) refuse("G76 with R{}: it must be 1 or more", degression);
  if (slant < 0 || slant > 80) refuse("G76 with Q{}: the slant is between 0 and 80 degrees", slant);
  if (springs < 0 || ends < 0 || ends > 3) refuse("G76 with a bad H or L");
  const bool entry = (ends & 1) != 0, exit = (ends & 2) != 0;
  const AxisValues start = at_;
  const double z_end = target().at[2], way = z_end < start.at[2] ? -1 : 1, inward = peak < 0 ? -1 : 1;
  if (taper < 0 || (entry && exit ? 2 : 1) * taper > std::abs(z_end - start.at[2]))
    refuse("G76 with E beyond the thread's length");

  const double speed = std::abs(spindle_at(at_));
  const auto go = [&](bool cut, double x, double z, double per_turn = 0) {
    AxisValues to = start;
    to.at[0] = x, to.at[2] = z;
    Motion motion = stamped(cut ? Motion::Kind::feed : Motion::Kind::rapid);
    motion.end = to;
    motion.feed = per_turn * speed;
    at_ = to;
    give(motion);
  };
  const double slope = std::tan(to_radians(slant));
  const double taper_pitch = taper > 0 ? pitch * std::hypot(taper, full) / taper : pitch;
  const auto pass = [&](double depth) {
    const double cut = start.at[0] + peak + inward * depth, safe = start.at[0] - inward * (full - depth);
    const double begin = start.at[2] + way * depth * slope, end = z_end - way * (full - depth) * slope;
    const double shallow = cut - inward * full;
    go(false, safe, begin);
    if (entry) {
      go(true, shallow, begin, taper_pitch);
      go(true, cut, begin + way * taper, taper_pitch);
    } else {
      go(false, cut, begin);
    }
    go(true, cut, exit ? end - way * taper : end, pitch);
    if (exit) go(true, shallow, end, taper_pitch);
    go(false, safe, end);
  };
  int passes = 0;
  for (double depth = first_cut; depth < full; depth = first_cut * std::pow(passes + 1, 1 / degression)) {
    pass(depth);
    flow_.count();
    if (++passes > 100'000) refuse("G76 with more than 100000 passes");
  }
  for (int i = 0; i <= springs; ++i) pass(full);
  go(false, start.at[0], z_end);
}

}  // namespace fieldfab::cam::gcode
