#include "filter.h"

#include <fmt/format.h>

#include <cmath>

#include "fieldfab/core/error.h"
#include "filters/all.h"

namespace fieldfab::meshlab {

const Parameter& Values::find(const std::string& name) const {
  for (const Parameter& parameter : parameters_)
    if (parameter.name == name) return parameter;
  throw Error(ErrorKind::internal, name, "is not a parameter of this filter");
}

double Values::positive(const std::string& name) const {
  const double value = number(name);
  if (!std::isfinite(value) || value <= 0)
    throw Error(ErrorKind::bad_input, name, fmt::format("must be above 0, not {:g}", value));
  return value;
}

double Values::not_negative(const std::string& name) const {
  const double value = number(name);
  if (!std::isfinite(value) || value < 0)
    throw Error(ErrorKind::bad_input, name, fmt::format("must not be below 0, as {:g} is", value));
  return value;
}

const Layer& Values::layer() const {
  const auto found = layers_.find(current_);
  if (found == layers_.end()) throw Error(ErrorKind::bad_input, "layer", "there is none; open a mesh first");
  return *found->second;
}

const Layer& Values::layer(const std::string& name) const {
  const auto found = layers_.find(static_cast<std::size_t>(number(name)));
  if (found == layers_.end()) throw Error(ErrorKind::bad_input, name, "there is no such layer");
  return *found->second;
}

void Result::add(Layer layer) {
  const TriangleMesh& mesh = layer.mesh;
  log.push_back(fmt::format("{} triangles, {:.6g} mm3, {:.6g} mm2", mesh.triangles.size(), mesh.volume(), mesh.area()));
  layers.push_back(std::move(layer));
}

const std::vector<Filter>& filters() {
  static const std::vector<Filter> all{remesh(),     offset_layer(), hollow(),    combine_layers(), lattice_infill(),
                                       frep_solid(), volume_solid(), deviation(), validity_report()};
  return all;
}

}  // namespace fieldfab::meshlab
