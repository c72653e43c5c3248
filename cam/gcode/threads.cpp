#include "threads.h"

#include <cmath>

#include "fieldfab/core/angle.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr int most_passes = 100'000;

}  // namespace

void cut_thread(const Thread& thread, const std::function<void(const ThreadMove&)>& give,
                const std::function<void()>& count) {
  const double way = thread.end < thread.start ? -1 : 1, inward = thread.peak < 0 ? -1 : 1;
  const double slope = std::tan(to_radians(thread.slant));
  const double taper_pitch =
      thread.taper > 0 ? thread.pitch * std::hypot(thread.taper, thread.full) / thread.taper : thread.pitch;
  const auto rapid = [&](double x, double z) { give({x, z, 0}); };
  const auto pass = [&](double depth) {
    const double left = thread.full - depth;
    const double cut = thread.x + thread.peak + inward * depth, safe = thread.x - inward * left;
    const double begin = thread.start + way * depth * slope, end = thread.end - way * left * slope;
    const double shallow = cut - inward * thread.full;
    rapid(safe, begin);
    if (thread.entry) {
      give({shallow, begin, taper_pitch});
      give({cut, begin + way * thread.taper, taper_pitch});
    } else {
      rapid(cut, begin);
    }
    give({cut, thread.exit ? end - way * thread.taper : end, thread.pitch});
    if (thread.exit) give({shallow, end, taper_pitch});
    rapid(safe, end);
  };
  int passes = 0;
  for (double depth = thread.first_cut; depth < thread.full;
       depth = thread.first_cut * std::pow(passes + 1, 1 / thread.degression)) {
    pass(depth);
    count();
    if (++passes > most_passes) refuse("G76 with more than {} passes", most_passes);
  }
  for (int i = 0; i <= thread.springs; ++i) pass(thread.full);
  rapid(thread.x, thread.end);
}

}  // namespace fieldfab::cam::gcode
