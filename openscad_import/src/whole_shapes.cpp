// hull, minkowski, resize and projection: operations that need the whole shape of their children.
#include <fmt/format.h>

#include <cmath>

#include "convex_pieces.h"
#include "evaluator.h"
#include "fieldfab/core/error.h"

namespace fieldfab::openscad {
namespace {

const Eigen::Affine3d at_home = Eigen::Affine3d::Identity();

std::vector<Vec3> corners_of(const std::vector<Polyhedron>& solids) {
  std::vector<Vec3> points;
  for (const Polyhedron& solid : solids) points.insert(points.end(), solid.vertices.begin(), solid.vertices.end());
  return points;
}

/// Returns the triangles of a surface, each as a polyhedron.
std::vector<Polyhedron> triangles_of(const Polyhedron& solid) {
  std::vector<Polyhedron> pieces;
  for (const Triangle& t : solid.triangles) {
    Polyhedron piece;
    for (const std::uint32_t i : t) piece.vertices.push_back(solid.vertices[i]);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace

PartPtr Evaluator::hull(const Node& node, const Eigen::Affine3d& placement, int depth) {
  bool convex = true;
  return part_of(convex_leaf(convex_hull(corners_of(pieces_of(*united(node, placement, depth), convex, progress_)))));
}

PartPtr Evaluator::minkowski(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth) {
  PartPtr total;
  for (const NodeIndex child : children(node, 3)) {
    // A translation of one operand moves the sum; rotation and scaling apply to all.
    Eigen::Affine3d here = placement;
    if (total != nullptr) here.translation().setZero();
    const PartPtr part = solid(child, here, depth);
    if (part->empty()) continue;  // as in OpenSCAD
    total = total == nullptr ? part : sum(total, part, a);
  }
  return total == nullptr ? nothing() : total;
}

PartPtr Evaluator::sum(const PartPtr& one, const PartPtr& two, const Arguments& a) {
  for (const bool swapped : {false, true}) {
    const Part &ball = swapped ? *one : *two, &other = swapped ? *two : *one;
    if (ball.kind != Part::Kind::leaf) continue;
    if (const auto round = ball.leaf->ball())
      return part_of(rounded_leaf(
          fieldfab::moved(polyhedron_of(other, progress_), Eigen::Affine3d(Eigen::Translation3d(round->centre))),
          round->radius));
  }
  bool one_convex = true, two_convex = true;
  std::vector<Polyhedron> first = pieces_of(*one, one_convex, progress_),
                          second = pieces_of(*two, two_convex, progress_);
  if (first.empty() || second.empty()) return nothing();
  std::vector<PartPtr> parts;
  // A solid that is not convex is cut into convex pieces. If that fails, the sum consists of the
  // sums of its surface triangles, and of the solid itself moved to one point of the other.
  const auto open = [&](std::vector<Polyhedron>& pieces, const PartPtr& part, const Polyhedron& other) {
    if (auto convex = convex_pieces(*part, progress_)) {
      pieces = std::move(*convex);
      return;
    }
    const Polyhedron whole = polyhedron_of(*part, progress_);
    parts.push_back(
        part_of(mesh_leaf(fieldfab::moved(whole, Eigen::Affine3d(Eigen::Translation3d(other.vertices.front()))))));
    pieces = triangles_of(whole);
  };
  const Polyhedron one_piece = first.front(), other_piece = second.front();
  if (!one_convex) open(first, one, other_piece);
  if (!two_convex) open(second, two, one_piece);
  constexpr std::size_t most = 200'000;
  if (first.size() * second.size() > most)
    a.fail(fmt::format("the sum would be of {} pieces; more than {} are not made", first.size() * second.size(), most));
  for (const Polyhedron& p : first)
    for (const Polyhedron& q : second) {
      progress_.check();
      std::vector<Vec3> points;
      points.reserve(p.vertices.size() * q.vertices.size());
      for (const Vec3& u : p.vertices)
        for (const Vec3& v : q.vertices) points.push_back(u + v);
      parts.push_back(part_of(convex_leaf(convex_hull(points))));
    }
  return unite(std::move(parts));
}

PartPtr Evaluator::resize(const Arguments& a, const Node& node, const Eigen::Affine3d& placement, int depth) {
  const PartPtr part = united(node, at_home, depth);
  bool convex = true;
  const std::vector<Polyhedron> pieces = pieces_of(*part, convex, progress_);
  if (pieces.empty()) return nothing();
  Box box = pieces.front().bounds();
  for (const Polyhedron& piece : pieces) box = fieldfab::hull(box, piece.bounds());
  const Vec3 size = box.size();
  const std::vector<double> factors =
      resize_factors(a.numbers("newsize", {0, 0, 0}), a.numbers("auto", {0, 0, 0}), {size.x(), size.y(), size.z()});
  return united(node, placement * Eigen::Affine3d(Eigen::Scaling(factors[0], factors[1], factors[2])), depth);
}

Region Evaluator::projection(const Arguments& a, const Node& node, int depth) {
  const PartPtr part = united(node, at_home, depth);
  if (a.truth("cut", false)) return slice_of(*part, progress_);
  bool convex = true;
  std::vector<Region> shadows;
  for (const Polyhedron& piece : pieces_of(*part, convex, progress_)) {
    progress_.check();
    shadows.push_back(shadow(piece));
  }
  return shadows.empty() ? Region{} : unite(shadows);
}

}  // namespace fieldfab::openscad
