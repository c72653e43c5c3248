// cube, sphere, cylinder, polyhedron, extrusions and imported meshes, with exactly the faces that
// OpenSCAD gives them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluator.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/linear_maps.h"
#include "imports.h"

namespace fieldfab::openscad {
namespace {

constexpr double pi = std::numbers::pi;

/// Adds a polygon as triangles: as a fan if it is convex, otherwise triangulated in its own plane.
void add_face(Polyhedron& solid, const std::vector<std::uint32_t>& corners) {
  if (corners.size() < 3) return;
  const auto fan = [&] {
    for (std::size_t i = 2; i < corners.size(); ++i)
      solid.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  };
  if (corners.size() == 3) return fan();
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += solid.vertices[corners[i]].cross(solid.vertices[corners[(i + 1) % corners.size()]]);
  if (!(area.norm() > 0)) return fan();
  const Vec3 normal = area.normalized();
  const Eigen::Quaterniond flatten = turn_between(normal, Vec3::UnitZ());
  Outline outline;
  for (const std::uint32_t i : corners) outline.push_back((flatten * solid.vertices[i]).head<2>());
  bool convex = true;
  for (std::size_t i = 0; i < outline.size() && convex; ++i) {
    const Vec2 u = outline[(i + 1) % outline.size()] - outline[i],
               v = outline[(i + 2) % outline.size()] - outline[(i + 1) % outline.size()];
    convex = u.x() * v.y() - u.y() * v.x() >= 0;
  }
  if (convex) return fan();
  try {
    for (const auto& t : triangulate({{outline}}))
      solid.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  } catch (const Error&) {
    fan();  // no better result for a face that intersects itself
  }
}

/// Number of edges that are not passed once in each direction.
std::size_t open_edges(const Polyhedron& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const Triangle& t : solid.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      balance[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// Length of the path of a point `radius` mm from the axis that is rotated by `angle` radians and
/// raised by `height` mm while the shape is scaled by `scale`: part of an Archimedean spiral.
double way_of(double radius, double angle, double scale, double height) {
  if (scale == 1) return std::hypot(radius * angle, height);
  const auto from_axis = [](double t) { return 0.5 * (t * std::sqrt(1 + t * t) + std::asinh(t)); };
  const double end = angle * std::max(scale, 1.0) / std::abs(scale - 1);
  return std::hypot(radius / end * (from_axis(end) - from_axis(end - angle)), height);
}

/// Number of slices of an extrusion that is twisted or scaled unevenly, by OpenSCAD's rules for the
/// default.
int slices_of(const Arguments& a, const Region& region, double height, double twist, const Vec2& scale) {
  const double fn = a.number("$fn", 0), fa = std::max(a.number("$fa", 12), 0.01),
               fs = std::max(a.number("$fs", 2), 0.01);
  double farthest = 0, widest = 0;  // distance from the axis; greatest outward movement of a corner
  for (const Outline& outline : region.outlines)
    for (const Vec2& p : outline) {
      farthest = std::max(farthest, p.norm());
      widest = std::max(widest, (p - p.cwiseProduct(scale)).norm());
    }
  double slices = 1;
  if (twist != 0) {
    const double angle = std::abs(twist) * pi / 180, least = std::max(std::ceil(std::abs(twist) / 120), 1.0);
    const double way = way_of(farthest, angle, scale.x() == scale.y() ? scale.x() : 1, height);
    slices = std::max(std::ceil(fn > 0 ? std::abs(twist) / 360 * fn : std::min(std::abs(twist) / fa, way / fs)), least);
  } else if (scale.x() != scale.y()) {
    slices = fn > 0 ? std::floor(fn) : std::ceil(std::hypot(widest, height) / fs);
  }
  constexpr double most = 100000;
  return static_cast<int>(std::clamp(slices, 1.0, most));
}

}  // namespace

PartPtr Evaluator::cube(const Arguments& a, const Eigen::Affine3d& placement) {
  const std::vector<double> size = a.numbers("size", {1, 1, 1});
  for (const double side : size)
    if (!(side > 0) || !std::isfinite(side)) return nothing();
  const Vec3 lower = a.truth("center", false) ? Vec3(-size[0] / 2, -size[1] / 2, -size[2] / 2) : Vec3(0, 0, 0);
  Polyhedron solid;
  for (int i = 0; i < 8; ++i)
    solid.vertices.push_back(lower +
                             Vec3((i & 1) != 0 ? size[0] : 0, (i & 2) != 0 ? size[1] : 0, (i & 4) != 0 ? size[2] : 0));
  for (const auto& face :
       {std::vector<std::uint32_t>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_face(solid, face);
  if (placement.linear().determinant() == 0) return nothing();
  return part_of(convex_leaf(moved(solid, placement)));
}

PartPtr Evaluator::sphere(const Arguments& a, const Node& node, const Eigen::Affine3d& placement) {
  const double r = a.number("r", 1);
  if (!(r > 0) || !std::isfinite(r) || placement.linear().determinant() == 0) return nothing();
  const int count = sides(a, r, node);
  if (count == 0) return part_of(ball_leaf(r, placement));
  const int rings = (count + 1) / 2;
  Outline profile;  // the half x >= 0, closed along the axis
  const auto at = [&](int ring) { return pi * (ring + 0.5) / rings; };
  profile.emplace_back(0, -r * std::cos(at(0)));
  for (int ring = 0; ring < rings; ++ring) profile.emplace_back(r * std::sin(at(ring)), -r * std::cos(at(ring)));
  profile.emplace_back(0, -r * std::cos(at(rings - 1)));
  TurnedShape shape{{{profile}}, {count, 0, 2 * pi / count}, 2 * pi, true};
  Polyhedron solid = turned(shape.profile, 0, 2 * pi / count, count, true);
  return part_of(faceted_leaf(moved(solid, placement), std::move(shape), placement));
}

PartPtr Evaluator::cylinder(const Arguments& a, const Node& node, const Eigen::Affine3d& placement) {
  const double h = a.number("h", 1), r1 = a.number("r1", a.number("r", 1)), r2 = a.number("r2", a.number("r", 1));
  if (!(h > 0 && r1 >= 0 && r2 >= 0 && std::max(r1, r2) > 0) || !std::isfinite(h + r1 + r2)) return nothing();
  if (placement.linear().determinant() == 0) return nothing();
  const double lower = a.truth("center", false) ? -h / 2 : 0, upper = lower + h;
  const int count = sides(a, std::max(r1, r2), node);
  if (count == 0) return part_of(cone_leaf({r1, r2, lower, upper}, placement));
  Outline profile{{0, lower}};
  if (r1 > 0) profile.emplace_back(r1, lower);
  if (r2 > 0) profile.emplace_back(r2, upper);
  profile.emplace_back(0, upper);
  TurnedShape shape{{{profile}}, {count, 0, 2 * pi / count}, 2 * pi, true};
  Polyhedron solid = turned(shape.profile, 0, 2 * pi / count, count, true);
  return part_of(faceted_leaf(moved(solid, placement), std::move(shape), placement));
}

PartPtr Evaluator::polyhedron(const Arguments& a, const Node& node, const Eigen::Affine3d& placement) {
  Polyhedron solid;
  for (const auto& p : a.points("points", 3)) solid.vertices.emplace_back(p[0], p[1], p[2]);
  auto faces = a.paths("faces", solid.vertices.size());
  if (a.find("faces") == nullptr) faces = a.paths("triangles", solid.vertices.size());
  for (auto& face : faces) {
    std::reverse(face.begin(), face.end());  // OpenSCAD's faces are clockwise
    add_face(solid, face);
  }
  if (solid.empty() || placement.linear().determinant() == 0) return nothing();
  if (const std::size_t open = open_edges(solid); open > 0)
    note(node,
         fmt::format(
             "{} edges of this polyhedron have not one face on each side; gaps are closed as its faces wind around it",
             open));
  double volume = 0;
  for (const Triangle& t : solid.triangles)
    volume += solid.vertices[t[0]].dot(solid.vertices[t[1]].cross(solid.vertices[t[2]]));
  if (volume < 0)
    for (Triangle& t : solid.triangles) std::swap(t[1], t[2]);
  return part_of(mesh_leaf(moved(solid, placement)));
}

PartPtr Evaluator::linear_extrude(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth) {
  const double height = a.number("height", 100), twist = a.number("twist", 0);
  const std::vector<double> factors = a.numbers("scale", {1, 1});
  const Vec2 scale(std::max(factors[0], 0.0), std::max(factors[1], 0.0));
  if (!std::isfinite(height) || !std::isfinite(twist) || !scale.allFinite()) a.fail("has numbers that are not finite");
  const Region region = tidied(united_flat(node, depth));
  if (!(height > 0) || region.empty() || placement.linear().determinant() == 0) return nothing();
  const double lower = a.truth("center", false) ? -height / 2 : 0;
  if (twist == 0 && scale == Vec2(1, 1)) return part_of(extruded_leaf(region, lower, lower + height, placement));
  constexpr double most = 100000;
  const double asked = a.number("slices", 0);
  const int steps = asked >= 1 ? static_cast<int>(std::min(asked, most)) : slices_of(a, region, height, twist, scale);
  const auto place = [&](const Vec2& p, int step) -> Vec3 {
    const double share = static_cast<double>(step) / steps, angle = -twist * pi / 180 * share;
    const Vec2 turned(p.x() * std::cos(angle) - p.y() * std::sin(angle),
                      p.x() * std::sin(angle) + p.y() * std::cos(angle));
    const Vec2 wide = turned.cwiseProduct(Vec2(1, 1) + share * (scale - Vec2(1, 1)));  // scaled after the rotation
    return {wide.x(), wide.y(), lower + height * share};
  };
  return part_of(mesh_leaf(moved(sweep(separated(region), steps, place, {true, twist > 0}), placement)));
}

PartPtr Evaluator::rotate_extrude(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth) {
  double angle = a.number("angle", 360);
  if (!std::isfinite(angle) || angle < -360 || angle > 360) angle = 360;
  Region region = tidied(united_flat(node, depth));
  if (region.empty() || angle == 0 || placement.linear().determinant() == 0) return nothing();
  const Eigen::AlignedBox2d box = region.bounds();
  const bool full = std::abs(angle) == 360;
  double first = full ? pi : 0;
  constexpr double slack = 1e-5;
  if (box.min().x() < -slack && box.max().x() > slack)
    throw Error(ErrorKind::bad_input, a.place(), "rotate_extrude: all of the shape must lie on one side of the y axis");
  if (box.max().x() <= slack) {
    Eigen::Affine2d mirror = Eigen::Affine2d::Identity();
    mirror(0, 0) = -1;
    region = moved(region, mirror);
    first += pi;
  }
  for (Outline& outline : region.outlines)
    for (Vec2& p : outline) p.x() = std::max(p.x(), 0.0);
  const double total = angle * pi / 180;
  const double width = std::max(box.max().x(), 0.0) - std::min(box.min().x(), 0.0);
  int count = sides(a, width, node);
  if (count > 0) count = std::max(static_cast<int>(count * std::abs(angle) / 360), 1);
  if (count > 0 && full) count = std::max(count, 3);
  const double step = count > 0 ? std::abs(total) / count : 0;
  // A turn in the other direction is one that starts at its end.
  if (total < 0) first += total;
  TurnedShape shape{region, {count, first, step}, std::abs(total), full};
  if (count > 0 && step > pi * 0.9) {  // too few sides to go around the axis
    return part_of(mesh_leaf(moved(turned(region, first, step, count, full), placement)));
  }
  return part_of(turned_leaf(std::move(shape), placement));
}

PartPtr Evaluator::imported(const Arguments& a, const Node& node, const Eigen::Affine3d& placement) {
  const std::string name = a.text("file", "");
  if (name.empty()) a.fail("names no file");
  const std::filesystem::path file = folder_ / name;
  const bool centre = a.truth("center", false), invert = a.truth("invert", false);
  const std::string key = fmt::format("{} {} {} {}", node.name, centre, invert, file.string());
  auto& mesh = meshes_[key];
  try {
    if (mesh == nullptr)
      mesh = std::make_shared<const Polyhedron>(node.name == "surface" ? surface(file, centre, invert)
                                                                       : import_mesh(file, progress_));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::internal) throw;
    throw Error(error.kind(), a.place(), error.what());
  }
  if (mesh->empty() || placement.linear().determinant() == 0) return nothing();
  if (const std::size_t open = open_edges(*mesh); open > 0)
    note(node, fmt::format("{} edges of {} have not one face on each side; gaps are closed as its faces wind around it",
                           open, name));
  return part_of(mesh_leaf(moved(*mesh, placement)));
}

}  // namespace fieldfab::openscad
