// Codes without motion of dialects other than LinuxCNC's, which a simulation ignores.
#pragma once

#include <optional>
#include <string>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// Description ("exact stop") of a G code (times ten) that the dialect knows, that moves nothing,
/// and that this interpreter ignores; std::nullopt for other codes. LinuxCNC's dialect has none.
std::optional<std::string> passed_over_g(Dialect dialect, int code);

/// Whether an unknown M code may be ignored. Codes that change the order of blocks may not.
bool passes_over_m(Dialect dialect, int code);

}  // namespace fieldfab::cam::gcode
