/// Results of the kernel as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "fieldfab/field/certainty.h"
#include "fieldfab/field/measure.h"

namespace fieldfab::cli {

/// [lower x, y, z, upper x, y, z], mm.
nlohmann::ordered_json json_of(const Box& box);
nlohmann::ordered_json json_of(const Certainty& certainty);
/// {"volume": [least, most], "area": [least, most]} in mm3 and mm2; null for an infinite bound.
nlohmann::ordered_json json_of(const Measures& measures);

}  // namespace fieldfab::cli
