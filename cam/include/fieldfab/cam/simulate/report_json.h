/// Simulation reports for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fieldfab/cam/simulate/report.h"

namespace fieldfab::cam {

/// Returns the report as a JSON object, with one record per line if `with_lines` is set. Strings may contain bytes of
/// programs that are not valid UTF-8.
nlohmann::ordered_json json_of(const SimulationReport& report, bool with_lines);
/// Returns the report as JSON text in valid UTF-8.
std::string to_json(const SimulationReport& report, bool with_lines);

}  // namespace fieldfab::cam
