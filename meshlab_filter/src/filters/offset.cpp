// Layer offset outwards or inwards.
#include <fmt/format.h>

#include <cmath>

#include "../solids.h"
#include "all.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> parameters(const Document& document) {
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  std::vector<Parameter> rows{length_parameter("Distance", "Distance (mm)",
                                               "Above 0 outwards, where edges become round; below 0 inwards.",
                                               diagonal / 100, -diagonal, diagonal)};
  for (Parameter& row : fineness_parameters(document)) rows.push_back(std::move(row));
  return rows;
}

Result run(const Values& values, Progress& progress) {
  Result result;
  const Fineness fineness = fineness_of(values);
  const double distance = values.number("Distance");
  if (!std::isfinite(distance)) throw Error(ErrorKind::bad_input, "Distance", "must be a finite number");
  const Layer& layer = values.layer();
  const Solid solid = solid_of(layer, fineness, std::abs(distance), result.log, progress);
  result.add(layer_of(offset(solid.field, distance), *solid.bounds, fineness, is_sharp(solid),
                      fmt::format("{} offset by {:g}", layer.name, distance), result.log, progress));
  return result;
}

}  // namespace

Filter offset_layer() {
  return {"Fieldfab: Offset",
          "The solid grown or shrunk by a distance, everywhere the same, whatever the mesh was like. Outwards, edges "
          "become round; "
          "inwards, what is thinner than "
          "twice the distance goes. Out and in again closes gaps, in and out again removes what is thin. The result is "
          "a new layer.",
          Filter::Group::remeshing,
          true,
          false,
          parameters,
          run};
}

}  // namespace fieldfab::meshlab
