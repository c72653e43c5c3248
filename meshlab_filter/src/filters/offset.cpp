// Layer offset outwards or inwards.
#include <fmt/format.h>

#include <cmath>

#include "../solids.h"
#include "all.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> offset_parameters(const Document& document) {
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  std::vector<Parameter> rows{length_parameter(
      "Distance", "Distance (mm)", "Positive values outwards, where edges become round; negative values inwards.",
      diagonal / 100, -diagonal, diagonal)};
  for (Parameter& row : fineness_parameters(document)) rows.push_back(std::move(row));
  return rows;
}

Result run_offset(const Values& values, Progress& progress) {
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
          "Grows or shrinks the solid by a constant distance, whatever the quality of the mesh. Outwards, edges "
          "become round; inwards, parts thinner than twice the distance vanish. Outwards and back (closing) fills "
          "gaps, inwards and back (opening) removes thin parts. The result is a new layer.",
          Filter::Group::remeshing,
          true,
          false,
          offset_parameters,
          run_offset};
}

}  // namespace fieldfab::meshlab
