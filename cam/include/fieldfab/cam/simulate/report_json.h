/// The report on a simulation, for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fieldfab/cam/simulate/report.h"

namespace fieldfab::cam {

/// The report as an object; `with_lines`: and what each line did. Texts may hold bytes of programs that are no UTF-8.
nlohmann::ordered_json json_of(const SimulationReport& report, bool with_lines);
/// Its text, valid UTF-8.
std::string to_json(const SimulationReport& report, bool with_lines);

}  // namespace fieldfab::cam
