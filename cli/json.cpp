#include "json.h"

#include <cmath>

namespace fieldfab::cli {

nlohmann::ordered_json json_of(const Box& box) {
  return {box.lower.x(), box.lower.y(), box.lower.z(), box.upper.x(), box.upper.y(), box.upper.z()};
}

nlohmann::ordered_json json_of(const Certainty& certainty) {
  auto places = nlohmann::ordered_json::array();
  for (const UncertainPlace& place : certainty.places)
    places.push_back({{"bounds", json_of(place.box)}, {"thickness", place.thickness}});
  nlohmann::ordered_json json{{"count", certainty.count},         {"largest", certainty.largest},
                              {"thickness", certainty.thickness}, {"finest", certainty.finest},
                              {"text", certainty.text()},         {"places", places}};
  if (certainty.wanted_voxel > 0) {
    json["wanted_voxel"] = certainty.wanted_voxel;
    json["wanted_triangles"] = certainty.wanted_triangles;
  }
  return json;
}

nlohmann::ordered_json json_of(const Measures& measures) {
  const auto range = [](const Enclosed& number) {
    return nlohmann::ordered_json{number.lower,
                                  std::isfinite(number.upper) ? nlohmann::ordered_json(number.upper) : nullptr};
  };
  return {{"volume", range(measures.volume)}, {"area", range(measures.area)}};
}

}  // namespace fieldfab::cli
