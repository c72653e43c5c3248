// What the dialects but LinuxCNC's know besides: codes without a motion, which a simulation passes over.
#pragma once

#include <optional>
#include <string>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// What a G code (times ten) that this interpreter does not carry out is in a dialect, where it moves nothing: "exact stop". None
/// for others; LinuxCNC's has none.
std::optional<std::string> passed_over_g(Dialect dialect, int code);

/// Whether an M code that is not known here may be passed over. Those that change which block comes next may not.
bool passes_over_m(Dialect dialect, int code);

}  // namespace fieldfab::cam::gcode
