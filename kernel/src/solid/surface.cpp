#include "fieldfab/solid/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"

namespace fieldfab {

Box working_bounds(const Solid& solid, const std::optional<Box>& wanted, Progress& progress, EmptySolid empty) {
  if (wanted) {
    if (!wanted->valid() || wanted->size().minCoeff() <= 0)
      throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x, y and z");
    return *wanted;
  }
  if (solid.bounds) return *solid.bounds;
  const SolidBounds found = solid_bounds(*solid.field, progress);
  if (found.empty && empty == EmptySolid::allowed) return {Vec3::Constant(-1), Vec3::Constant(1)};
  if (found.empty)
    throw Error(ErrorKind::bad_input, "bounds", "the solid is empty; give bounds to work on a region all the same");
  std::string open;
  for (int axis = 0; axis < 3; ++axis)
    if (!found.bounded[axis]) open += fmt::format("{}{}", open.empty() ? "" : ", ", "xyz"[axis]);
  if (!open.empty())
    throw Error(ErrorKind::bad_input, "bounds",
                fmt::format("the solid is unbounded along {}; give bounds x0,y0,z0,x1,y1,z1{}", open,
                            open == "z" ? ", or a thickness to make a plate of a flat model" : ""));
  return found.box.grown(found.box.size().maxCoeff() / 64);
}

double default_voxel(const Solid& solid, const Box& region, double cells) {
  if (!(cells > 0)) throw Error(ErrorKind::bad_input, "cells", fmt::format("{} is not a positive number", cells));
  return solid.voxel.value_or(region.size().maxCoeff() / cells);
}

LatticeCells lattice_cells(const Solid& solid, const Box& region, Progress& progress) {
  LatticeCells cells;
  cells.voxel = default_voxel(solid, region);
  cells.certainty = certainty_of_cells(*solid.field, region, cells.voxel, progress);
  for (const double part : {0.5, 0.25}) {
    if (cells.certainty.certain() || cells.certainty.doubt != Doubt::finest_size) break;
    const double voxel = part * default_voxel(solid, region);
    if (certainty_of_cells(*solid.field, region, voxel, progress).certain()) return {voxel, {}};
  }
  return cells;
}

std::vector<Colour> vertex_colours(const TriangleMesh& mesh, const Model& model) {
  std::vector<Colour> colours;
  if (std::none_of(model.parts.begin(), model.parts.end(), [](const Solid& part) { return part.colour.has_value(); }))
    return colours;
  constexpr Colour plain{204, 204, 204};
  colours.assign(mesh.vertices.size(), plain);
  std::vector<float> x, y, z;
  for (const auto& v : mesh.vertices) x.push_back(v[0]), y.push_back(v[1]), z.push_back(v[2]);
  std::vector<float> least(colours.size(), std::numeric_limits<float>::infinity()), value(colours.size());
  for (const Solid& part : model.parts) {
    part.field->values({x.data(), y.data(), z.data(), x.size()}, value.data());
    for (std::size_t i = 0; i < colours.size(); ++i)
      if (value[i] < least[i]) least[i] = value[i], colours[i] = part.colour.value_or(plain);
  }
  return colours;
}

Surface surface(const Solid& solid, const Resolution& resolution, Progress& progress, EmptySolid empty) {
  Surface made;
  if (resolution.exact && solid.faces != nullptr && !resolution.region)
    if (auto faces = solid.faces(std::nullopt, progress)) {
      static_cast<TriangleMesh&>(made.mesh) = std::move(*faces);
      made.exact = true;
    }
  made.region = made.exact ? made.mesh.bounds() : working_bounds(solid, resolution.region, progress, empty);
  made.voxel = resolution.voxel.value_or(default_voxel(solid, made.region));
  if (!made.exact)
    made.mesh = contour(*solid.field, made.region, {made.voxel, resolution.max_error.value_or(-1), resolution.features},
                        progress);
  return made;
}

}  // namespace fieldfab
