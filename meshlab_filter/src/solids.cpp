#include "solids.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cost.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/mesh_distances.h"
#include "fieldfab/mesh/mesh_field.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/volume/distances.h"
#include "fieldfab/volume/volume_field.h"

namespace fieldfab::meshlab {
namespace {

constexpr double cheap = 600e6;  // bytes of a lattice up to which its spacing may be half the voxel, for accuracy

Vec3 place(const TriangleMesh& mesh, std::uint32_t vertex) {
  const auto& p = mesh.vertices[vertex];
  return {p[0], p[1], p[2]};
}

/// Returns for each vertex the representative of all vertices at its position.
std::vector<std::uint32_t> merged(const std::vector<std::array<float, 3>>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), stands(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto finite = [&](std::uint32_t v) {
    return std::isfinite(vertices[v][0]) && std::isfinite(vertices[v][1]) && std::isfinite(vertices[v][2]);
  };
  std::iota(stands.begin(), stands.end(), 0u);
  order.erase(std::remove_if(order.begin(), order.end(), [&](std::uint32_t v) { return !finite(v); }), order.end());
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (vertices[order[i]] == vertices[order[i - 1]]) stands[order[i]] = stands[order[i - 1]];
  return stands;
}

double area_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = place(mesh, t[0]);
  return 0.5 * (place(mesh, t[1]) - a).cross(place(mesh, t[2]) - a).norm();
}

/// Whether most of the surface consists of triangles larger than a few voxels: then edges are
/// drawn, not noise.
bool is_drawn(const TriangleMesh& mesh, const Fineness& fineness) {
  if (fineness.edges == Fineness::Edges::rounded) return false;
  double all = 0, large = 0;
  for (const auto& t : mesh.triangles) {
    const double area = area_of(mesh, t);
    all += area;
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, (place(mesh, t[i]) - place(mesh, t[(i + 1) % 3])).norm());
    if (longest > 4 * fineness.voxel) large += area;
  }
  return large > 0.8 * all;
}

/// Whether edges are searched for. In solids only a few voxels thick the search takes too long.
bool is_sharpened(const TriangleMesh& mesh, const Fineness& fineness) {
  return fineness.edges == Fineness::Edges::kept ||
         (is_drawn(mesh, fineness) && 2 * std::abs(mesh.volume()) > 8 * fineness.voxel * mesh.area());
}

/// The distances on a lattice as a Field; points beyond its samples are outside.
FieldPtr sampled(const TriangleMesh& mesh, const Box& bounds, double voxel, Progress& progress) {
  DistanceLattice lattice;
  lattice.spacing = voxel;
  lattice.origin = bounds.lower;
  for (std::size_t axis = 0; axis < 3; ++axis)
    lattice.size[axis] = static_cast<int>(std::ceil(bounds.size()[static_cast<Eigen::Index>(axis)] / voxel)) + 1;
  SampleLattice samples;
  samples.size = lattice.size, samples.spacing = Vec3::Constant(voxel), samples.origin = lattice.origin;
  const VolumePtr volume = volume_of(mesh_distances(mesh, lattice, 2 * voxel, progress), samples);
  return volume_field(*volume, {0, true, 1}, progress);
}

/// Logs the certainty of an intermediate mesh, unless it is certain.
void warn_where_uncertain(const Layer& layer, const Certainty& certainty, std::vector<std::string>& log) {
  if (!certainty.certain())
    log.push_back(fmt::format("layer '{}', as the solid it encloses, is {}", layer.name, certainty.text()));
}

}  // namespace

TriangleMesh usable_triangles(const Layer& layer, std::vector<std::string>& log) {
  const std::string place_of_error = "layer '" + layer.name + "'";
  if (layer.mesh.triangles.empty()) throw Error(ErrorKind::bad_input, place_of_error, "has no triangles");
  const std::vector<std::uint32_t> stands = merged(layer.mesh.vertices);
  TriangleMesh usable;
  std::vector<std::uint32_t> name(layer.mesh.vertices.size(), ~0u);
  std::size_t nowhere = 0, flat = 0;
  for (const auto& t : layer.mesh.triangles) {
    const double area = area_of(layer.mesh, t);
    if (!std::isfinite(area)) {
      ++nowhere;
      continue;
    }
    const std::array<std::uint32_t, 3> own{stands[t[0]], stands[t[1]], stands[t[2]]};
    // A triangle without area, but with three different vertices, is needed to keep the mesh closed.
    if (own[0] == own[1] || own[1] == own[2] || own[2] == own[0]) {
      ++flat;
      continue;
    }
    for (const std::uint32_t v : own)
      if (name[v] == ~0u) {
        name[v] = static_cast<std::uint32_t>(usable.vertices.size());
        usable.vertices.push_back(layer.mesh.vertices[v]);
      }
    usable.triangles.push_back({name[own[0]], name[own[1]], name[own[2]]});
  }
  if (nowhere > 0)
    log.push_back(fmt::format("{}: {} triangles have places that are not finite numbers; they are left out",
                              place_of_error, nowhere));
  if (flat > 0) log.push_back(fmt::format("{}: {} triangles have no area; they are left out", place_of_error, flat));
  if (usable.triangles.empty() || !(usable.area() > 0))
    throw Error(ErrorKind::bad_input, place_of_error,
                fmt::format("none of its {} triangles has an area and finite places", layer.mesh.triangles.size()));
  return usable;
}

FieldPtr with_distances(const FieldPtr& field, const Box& bounds, double reach, double voxel, Progress& progress) {
  require(lattice_cost(bounds.grown(reach + 2 * voxel), voxel), voxel, 3);
  return distances(field, bounds.grown(reach + 2 * voxel), {reach + 2 * voxel, voxel}, progress);
}

std::optional<ExactSolid> exact_solid_of(const Layer& layer, const Fineness& fineness, std::vector<std::string>& log,
                                         Progress& progress) {
  constexpr std::size_t most = 50'000;  // triangles
  if (layer.mesh.triangles.size() > most) return std::nullopt;
  std::vector<std::string> said;
  const TriangleMesh mesh = usable_triangles(layer, said);
  if (!is_drawn(mesh, fineness)) return std::nullopt;
  require(surface_cost(mesh.area(), fineness.voxel), fineness.voxel, 2);
  auto exact = fieldfab::exact_solid_of(mesh, progress);
  if (!exact) return std::nullopt;
  said.push_back(fmt::format("layer '{}' is a drawn part: its faces stay as they are, exactly", layer.name));
  log.insert(log.end(), said.begin(), said.end());
  return exact;
}

Solid solid_of(const Layer& layer, const Fineness& fineness, double reach, std::vector<std::string>& log,
               Progress& progress) {
  progress.report(0, "reading the layer");
  TriangleMesh mesh = usable_triangles(layer, log);
  const double voxel = fineness.voxel;
  const Box tight = mesh.bounds();
  bool sharp = is_sharpened(mesh, fineness);
  require(sharp ? surface_cost(mesh.area(), voxel) : lattice_cost(tight.grown(3 * voxel), voxel), voxel, sharp ? 2 : 3);

  if (const Lids lids = lids_of(mesh); !lids.triangles.empty()) {
    TriangleMesh closed = closed_by(lids, mesh);
    bool pieces = !lids.are_small(mesh);
    if (pieces) {  // then the winding number counts if triangles cover half of the view
      const ContourMesh wrapped =
          contour(*mesh_field(mesh, progress), tight.grown(2 * voxel), {voxel, -1, false}, progress);
      pieces = std::abs(closed.volume()) < 0.5 * wrapped.volume();
      sharp = false;
      if (pieces) {
        closed = wrapped;
        warn_where_uncertain(layer, wrapped.certainty, log);
      }
    }
    if (std::abs(closed.volume()) < 1e-9 * std::pow(mesh.area(), 1.5))
      throw Error(ErrorKind::bad_input, "layer '" + layer.name + "'",
                  "encloses nothing; a sheet becomes solid by Shell, on both sides");
    log.push_back(
        pieces ? fmt::format("layer '{}' is a soup of pieces: the solid is what they wind around by more than half",
                             layer.name)
               : fmt::format("layer '{}' is open: {} rims are closed by lids of {:.3g} mm2", layer.name, lids.rims,
                             lids.area));
    mesh = std::move(closed);
  }

  if (sharp) {
    // Triangles within the solid are no surface to measure from.
    if (reach > 0 && inspect(mesh).self_intersections > 0) {
      log.push_back(
          fmt::format("layer '{}' intersects itself: distances are those to the solid that it encloses", layer.name));
      ContourMesh enclosed = contour(*mesh_field(mesh, progress), tight.grown(2 * voxel), {voxel}, progress);
      warn_where_uncertain(layer, enclosed.certainty, log);
      mesh = std::move(enclosed);
      if (mesh.triangles.empty())
        throw Error(ErrorKind::bad_input, "layer '" + layer.name + "'", "encloses nothing that is as thick as a voxel");
    }
    return fieldfab::solid_of(mesh_field(mesh, progress), "mesh", tight.grown(reach + 2 * voxel));
  }
  // Drawn faces lie on round numbers; the planes of the lattice do not.
  Box lattice = tight.grown(3 * voxel);
  lattice.lower -= voxel * Vec3(0.137, 0.241, 0.319);
  FieldPtr field = sampled(mesh, lattice, lattice_cost(lattice, voxel / 2) <= cheap ? voxel / 2 : voxel, progress);
  if (reach > 0) field = with_distances(field, tight, reach, voxel, progress);
  return fieldfab::solid_of(field, "mesh", tight.grown(reach + 2 * voxel));
}

std::optional<Layer> layer_of(const ExactSolid& solid, std::string name) {
  auto mesh = solid.empty() ? std::nullopt : in_single_precision(solid.polyhedron());
  if (!mesh) return std::nullopt;
  return Layer{std::move(name), std::move(*mesh)};
}

Layer layer_of(const FieldPtr& field, const Box& bounds, const Fineness& fineness, bool sharp, std::string name,
               std::vector<std::string>& log, Progress& progress) {
  ContourMesh mesh = contour(
      *field, bounds, {fineness.voxel, (sharp ? 0.05 : 0.01) * fineness.voxel, sharp, depth_for(*field)}, progress);
  if (mesh.triangles.empty())
    throw Error(ErrorKind::bad_input, "result",
                fmt::format("there is nothing left that is as thick as a voxel of {:.3g} mm", fineness.voxel));
  log.push_back(fmt::format("the mesh is {}", mesh.certainty.text()));
  return {std::move(name), std::move(mesh)};
}

Layer layer_of(const Model& model, const std::optional<Box>& bounds, double voxel, EmptySolid empty, std::string name,
               std::vector<std::string>& log, Progress& progress) {
  Solid solid = united(model);
  solid.bounds = working_bounds(solid, bounds, progress, empty);
  if (voxel == 0) voxel = default_voxel(solid, *solid.bounds);
  require_surface(*solid.bounds, voxel);
  Surface made = surface(solid, {voxel, 0.05 * voxel, bounds}, progress);
  ContourMesh& mesh = made.mesh;
  const std::string certain = mesh.certainty.text();
  if (mesh.triangles.empty()) {
    log.push_back(
        fmt::format("{}: {}", name, mesh.certainty.certain() ? "is empty" : "no surface was found; it is " + certain));
  } else {
    log.push_back(made.exact ? "the mesh has the solid's own faces" : "the mesh is " + certain);
    log.push_back(fmt::format("{}: {}, {} triangles, {:.6g} mm3, {:.6g} mm2, voxel {:.3g} mm", name, solid.kind,
                              mesh.triangles.size(), mesh.volume(), mesh.area(), voxel));
  }
  std::vector<Colour> colours = vertex_colours(mesh, model);
  return {std::move(name), std::move(mesh), std::move(colours)};
}

std::vector<std::string> extensions_read(FormatKind kind) {
  std::vector<std::string> extensions;
  for (const Format& format : openscad::all_formats().rows())
    if (format.kind == kind && format.read != nullptr)
      extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

Model model_of_file(const std::filesystem::path& file, Progress& progress) {
  OpenSettings settings;
  settings.formats = &openscad::all_formats();
  return open_model(file, settings, progress);
}

Model model_of_text(const std::string& text, Progress& progress) {
  std::error_code ignored;
  if (text.find('\n') == std::string::npos && std::filesystem::exists(text, ignored))
    return model_of_file(text, progress);
  if (text.find_first_not_of(" \t\n") == std::string::npos) throw Error(ErrorKind::bad_input, "formula", "is empty");
  OpenSettings settings;
  settings.formats = &openscad::all_formats();
  return parse_model(text, "formula", std::filesystem::current_path(), settings, progress);
}

}  // namespace fieldfab::meshlab
