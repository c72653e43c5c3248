#include "fieldfab/solid/solid.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/linear_maps.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/mesh/exact_solid.h"

namespace fieldfab {
namespace {

using frep::Expression;

/// Returns a FaceMaker whose faces are moved by an affine map from the leaf's coordinates.
FaceMaker moved_faces(const FaceMaker& faces, const Eigen::Affine3d& to_outer) {
  if (faces == nullptr || !(to_outer.linear().determinant() > 0)) return nullptr;
  return [faces, to_outer](std::optional<double> thickness, Progress& progress) -> std::optional<TriangleMesh> {
    // A plate stays one if it only moves along x and y, and rotates about z.
    const bool keeps_z = to_outer.linear().row(2) == Eigen::RowVector3d::UnitZ() &&
                         to_outer.linear().col(2) == Vec3::UnitZ() && to_outer.translation().z() == 0;
    if (thickness && !keeps_z) return std::nullopt;
    const auto mesh = faces(thickness, progress);
    if (!mesh) return std::nullopt;
    return in_single_precision(moved(to_polyhedron(*mesh), to_outer));
  };
}

/// Copies the metadata of a leaf, placed by an affine map, to the solid.
void take_from(const OpenedSolid& leaf, const Eigen::Affine3d& to_inner, Solid& solid) {
  solid.kind = leaf.kind;
  if (to_inner.matrix() == Eigen::Matrix4d::Identity()) {
    solid.voxel = leaf.voxel, solid.bounds = leaf.bounds, solid.faces = leaf.faces, solid.flat = leaf.flat;
    return;
  }
  const Eigen::Affine3d to_outer = to_inner.inverse();
  if (leaf.bounds) solid.bounds = image_of(*leaf.bounds, to_outer.linear(), to_outer.translation());
  solid.faces = moved_faces(leaf.faces, to_outer);
}

/// Returns the voxel of a leaf in space: divided by the greatest stretch of the map to the leaf's
/// coordinates if that is affine, otherwise unchanged.
double voxel_in_space(double voxel, const std::optional<Eigen::Affine3d>& to_inner) {
  if (!to_inner) return voxel;
  return voxel / stretch_of(to_inner->linear()).greatest;
}

}  // namespace

Solid solid_of(Expression expression) {
  Solid solid;
  const Expression simple = frep::simplify(expression);
  solid.field = frep::make_field(simple);
  solid.expression = std::move(expression);
  const std::vector<frep::PlacedLeaf> leaves = frep::leaves_of(simple);
  for (const frep::PlacedLeaf& leaf : leaves)
    if (const auto opened = std::dynamic_pointer_cast<const OpenedSolid>(leaf.source);
        opened != nullptr && opened->voxel) {
      const double voxel = voxel_in_space(*opened->voxel, leaf.to_inner);
      solid.voxel = solid.voxel ? std::min(*solid.voxel, voxel) : voxel;
    }
  // The root comes last.
  if (simple.opcode() == frep::Opcode::opened && leaves.back().to_inner)
    if (const auto opened = std::dynamic_pointer_cast<const OpenedSolid>(leaves.back().source))
      take_from(*opened, *leaves.back().to_inner, solid);
  return solid;
}

Solid solid_of(const std::shared_ptr<const OpenedSolid>& opened) {
  return solid_of(Expression::opened(opened, Expression::x(), Expression::y(), Expression::z()));
}

Solid solid_of(FieldPtr field, std::string kind, std::optional<Box> bounds, bool flat) {
  auto opened = std::make_shared<OpenedSolid>();
  opened->field = std::move(field);
  opened->kind = std::move(kind);
  opened->bounds = std::move(bounds);
  opened->flat = flat;
  return solid_of(opened);
}

Solid united(const Model& model) {
  if (model.parts.size() == 1) return model.parts.front();
  Expression all = model.parts.front().expression;
  for (std::size_t i = 1; i < model.parts.size(); ++i) all = min(all, model.parts[i].expression);
  return solid_of(all);
}

const Solid& part_of(const Model& model, const std::string& name, const std::string& place) {
  std::vector<std::string_view> names;
  for (const Solid& part : model.parts) {
    if (part.name == name) return part;
    if (!part.name.empty()) names.push_back(part.name);
  }
  throw Error(ErrorKind::bad_input, place, fmt::format("there is no part '{:.60}'{}", name, suggestion(name, names)));
}

Solid plate_of(const Solid& solid, double height) {
  if (!std::isfinite(height) || height <= 0)
    throw Error(ErrorKind::bad_input, "thickness", fmt::format("{} is not a positive number of mm", height));
  const Expression z = Expression::z();
  Solid plate = solid_of(max(solid.expression, max(-z, z - height)));
  if (solid.faces != nullptr)
    plate.faces = [faces = solid.faces, height](std::optional<double> again,
                                                Progress& progress) -> std::optional<TriangleMesh> {
      if (again) return std::nullopt;
      return faces(height, progress);
    };
  plate.kind = solid.kind, plate.name = solid.name, plate.colour = solid.colour;
  if (solid.voxel) plate.voxel = solid.voxel;
  return plate;
}

}  // namespace fieldfab
