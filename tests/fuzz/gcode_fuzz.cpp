// Any text as a program in each of the languages: an Error, or finite motions.
#include <cmath>
#include <cstdlib>
#include <string>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  cam::ReadingOptions options;
  options.tools[1] = {{0, 0, 10}, 6};
  options.tools[2] = {{1, 0, 25}, 4};
  options.most_blocks = 3000;
  std::size_t motions = 0;
  struct TooMany {};
  const auto sink = [&](const cam::Motion& motion) {
    for (const double value : motion.end.at)
      if (!std::isfinite(value)) std::abort();
    if (!motion.centre.allFinite() || !std::isfinite(motion.feed) || !std::isfinite(motion.seconds) ||
        !std::isfinite(motion.spindle))
      std::abort();
    if (motion.feed < 0 || motion.seconds < 0) std::abort();
    if (motion.kind == cam::Motion::Kind::arc && motion.turns == 0) std::abort();
    if (++motions > 100'000) throw TooMany();
  };
  try {
    switch (data[0] % 4) {
      case 1: (void)cam::read_sbp(text, "part.sbp", options, 25.4, sink); break;
      case 2: (void)cam::read_rml(text, "part.rml", options, 0.025, sink); break;
      case 3: (void)cam::read_hpgl(text, "part.hpgl", options, 0.025, 5, -1, sink); break;
      default: (void)cam::read_gcode(text, "part.ngc", options, sink); break;
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  } catch (const TooMany&) {
  }
  return 0;
}
