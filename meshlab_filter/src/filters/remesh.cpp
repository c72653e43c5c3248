// Conversion of any triangle soup to a closed mesh, by a distance field.
#include "../solids.h"
#include "all.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> remesh_parameters(const Document& document) {
  std::vector<Parameter> rows = fineness_parameters(document);
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  rows.push_back(
      length_parameter("GapWidth", "Gap width to close (mm)",
                       "Slits and cracks that are narrower than this are filled, also between parts; 0 fills none. "
                       "Holes of open meshes are always closed.",
                       0, 0, diagonal));
  return rows;
}

Layer through_a_field(const Layer& layer, const Fineness& fineness, double gap, std::vector<std::string>& log,
                      Progress& progress) {
  const Solid solid = solid_of(layer, fineness, 0, log, progress);
  FieldPtr field = solid.field;
  Box bounds = *solid.bounds;
  if (gap > 0) {  // grows by half the gap and shrinks again; the union keeps the original solid
    bounds = bounds.grown(gap);
    const FieldPtr grown = offset(with_distances(field, bounds, gap, fineness.voxel, progress), gap / 2);
    field = unite(field, offset(with_distances(grown, bounds, gap, fineness.voxel, progress), -gap / 2));
  }
  return layer_of(field, bounds, fineness, is_sharp(solid), layer.name + " remeshed", log, progress);
}

Result run_remesh(const Values& values, Progress& progress) {
  Result result;
  const Fineness fineness = fineness_of(values);
  const double gap = values.not_negative("GapWidth");
  const Layer& layer = values.layer();
  std::optional<Layer> made;
  if (gap == 0)
    if (const auto exact = exact_solid_of(layer, fineness, result.log, progress))
      made = layer_of(*exact, layer.name + " remeshed");
  result.add(made ? std::move(*made) : through_a_field(layer, fineness, gap, result.log, progress));
  return result;
}

}  // namespace

Filter remesh() {
  return {"Fieldfab: Remesh through a distance field",
          "A closed, manifold mesh without self-intersections from <b>any</b> triangle soup: open, inverted, self- "
          "intersecting or in pieces. The volume that the triangles enclose becomes solid; overlaps are united. The "
          "result is a new layer.",
          Filter::Group::remeshing,
          true,
          false,
          remesh_parameters,
          run_remesh};
}

}  // namespace fieldfab::meshlab
