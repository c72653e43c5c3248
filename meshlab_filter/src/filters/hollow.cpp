// Wall of even thickness, with holes that drain the hollow.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "../solids.h"
#include "all.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> hollow_parameters(const Document& document) {
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  std::vector<Parameter> rows{
      length_parameter("Wall", "Wall thickness (mm)", "Constant thickness of the wall.", diagonal / 40, 0, diagonal),
      choice_parameter("Side", "The wall lies", "On both sides it may be an open sheet, which gets that thickness.",
                       {"inside the surface", "outside the surface", "on both sides"}),
      whole_parameter(
          "DrainHoles", "Drain holes in each hollow",
          "The first at the lowest place, the second at the highest, for the air; further ones low again, apart from "
          "each other. They run along z.",
          0),
      length_parameter("HoleDiameter", "Drain hole diameter (mm)", "Wide enough for powder or resin.", diagonal / 30, 0,
                       diagonal)};
  for (Parameter& row : fineness_parameters(document)) rows.push_back(std::move(row));
  return rows;
}

/// Returns the vertices of each piece of a mesh.
std::vector<std::vector<Vec3>> pieces_of(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const auto& t : mesh.triangles) sets.unite(t[0], t[1]), sets.unite(t[0], t[2]);
  std::map<std::uint32_t, std::vector<Vec3>> pieces;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    pieces[sets.find(v)].emplace_back(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
  std::vector<std::vector<Vec3>> list;
  for (auto& [name, vertices] : pieces) list.push_back(std::move(vertices));
  return list;
}

/// Drain of a hollow: a point on its wall, and whether the hole goes up from there.
struct Drain {
  Vec3 place;
  bool up;
};

std::vector<Drain> drains_of(const std::vector<Vec3>& hollow, int count) {
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  const auto [lowest, highest] = std::minmax_element(hollow.begin(), hollow.end(), lower);
  std::vector<Drain> drains{{*lowest, false}};
  if (count > 1) drains.push_back({*highest, true});
  const double low = lowest->z() + 0.25 * (highest->z() - lowest->z());
  for (int n = 2; n < count; ++n) {
    const Vec3* farthest = &*lowest;
    double most = -1;
    for (const Vec3& p : hollow) {
      if (p.z() > low) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Drain& drain : drains) nearest = std::min(nearest, (p - drain.place).norm());
      if (nearest > most) most = nearest, farthest = &p;
    }
    drains.push_back({*farthest, false});
  }
  return drains;
}

/// Returns a hole from inside the hollow through its wall, up to the first point outside.
FieldPtr hole(const Field& outside, const Drain& drain, double diameter, double voxel, const Box& bounds) {
  const double way = drain.up ? 1 : -1;
  double z = drain.place.z();
  while (z > bounds.lower.z() && z < bounds.upper.z() && outside.value({drain.place.x(), drain.place.y(), z}) < 0)
    z += way * voxel / 2;
  const double from = drain.place.z() - way * diameter, to = z + way * diameter;
  const frep::Expression rod = frep::shapes::exact_cylinder(diameter / 2, std::abs(to - from));
  return translate(frep::make_field(rod), {drain.place.x(), drain.place.y(), 0.5 * (from + to)});
}

Result run_hollow(const Values& values, Progress& progress) {
  Result result;
  const Fineness fineness = fineness_of(values);
  const double wall = values.positive("Wall");
  const int side = values.whole("Side"), holes = values.whole("DrainHoles");
  if (side < 0 || side > 2) throw Error(ErrorKind::bad_input, "Side", fmt::format("is 0, 1 or 2, not {}", side));
  if (holes < 0 || holes > 100)
    throw Error(ErrorKind::bad_input, "DrainHoles", fmt::format("is from 0 to 100, not {}", holes));
  const double diameter = holes > 0 ? values.positive("HoleDiameter") : 0;
  const Layer& layer = values.layer();
  Solid solid;
  bool sharp = false;
  FieldPtr outer, inner, shelled;
  if (side == 2) {
    const TriangleMesh mesh = usable_triangles(layer, result.log);
    solid = fieldfab::solid_of(mesh_field(mesh, progress), "mesh", mesh.bounds().grown(wall + 2 * fineness.voxel));
    sharp = fineness.edges == Fineness::Edges::kept;
    shelled = shell(solid.field, wall);
    outer = offset(solid.field, wall / 2), inner = offset(solid.field, -wall / 2);
  } else {
    solid = solid_of(layer, fineness, wall, result.log, progress);
    sharp = is_sharp(solid);
    outer = side == 0 ? solid.field : offset(solid.field, wall),
    inner = side == 0 ? offset(solid.field, -wall) : solid.field;
    shelled = subtract(outer, inner);
  }
  if (wall < fineness.voxel)
    result.log.push_back(fmt::format("the wall is {:.2g} voxels thick: it may have holes", wall / fineness.voxel));
  if (holes > 0) {
    const ContourMesh hollow = contour(*inner, *solid.bounds, {fineness.voxel, -1, false, depth_for(*inner)}, progress);
    int made = 0;
    for (const std::vector<Vec3>& piece : pieces_of(hollow)) {
      for (const Drain& drain : drains_of(piece, holes))
        shelled = subtract(shelled, hole(*outer, drain, diameter, fineness.voxel, *solid.bounds)), ++made;
      if (made > 1000)
        throw Error(ErrorKind::bad_input, "DrainHoles", "there are too many hollows; a thicker wall leaves fewer");
    }
    result.log.push_back(fmt::format("{} drain holes", made));
    if (!hollow.certainty.certain())
      result.log.push_back(fmt::format("the hollow that is drained is {}", hollow.certainty.text()));
  }
  result.add(layer_of(shelled, *solid.bounds, fineness, sharp, layer.name + " hollow", result.log, progress));
  return result;
}

}  // namespace

Filter hollow() {
  return {"Fieldfab: Shell (hollow out)",
          "Hollows the solid: a wall of constant thickness along the surface, with drain holes if wanted. Open "
          "sheets become walls if the wall lies on both sides. The result is a new layer.",
          Filter::Group::remeshing,
          true,
          false,
          hollow_parameters,
          run_hollow};
}

}  // namespace fieldfab::meshlab
