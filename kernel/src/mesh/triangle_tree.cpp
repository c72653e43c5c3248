#include "triangle_tree.h"

#include <algorithm>
#include <limits>

namespace fieldfab {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

}  // namespace

std::vector<std::array<Vec3, 3>> corners_of_all(const TriangleMesh& mesh) {
  std::vector<std::array<Vec3, 3>> all;
  all.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = mesh.vertices[triangle[i]];
      corners[i] = Vec3(p[0], p[1], p[2]);
    }
    all.push_back(corners);
  }
  return all;
}

bool meet(const std::array<Vec3, 3>& triangle, const Box& box) {
  const Vec3 centre = box.centre(), half = box.size() / 2;
  const std::array<Vec3, 3> at{triangle[0] - centre, triangle[1] - centre, triangle[2] - centre};
  const auto parted_along = [&](const Vec3& way) {
    const double a = way.dot(at[0]), b = way.dot(at[1]), c = way.dot(at[2]), reach = way.cwiseAbs().dot(half);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
  };
  const std::array<Vec3, 3> edge{at[1] - at[0], at[2] - at[1], at[0] - at[2]};
  if (parted_along(edge[0].cross(edge[1]))) return false;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    if (parted_along(axis)) return false;
    for (const Vec3& along : edge)
      if (parted_along(axis.cross(along))) return false;
  }
  return true;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : triangles_(corners_of_all(mesh)) {
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  divide(0, 0, static_cast<std::uint32_t>(triangles_.size()));
}

Box TriangleTree::divide(std::size_t node, std::uint32_t first, std::uint32_t count) {
  const auto begin = triangles_.begin() + first, end = begin + count;
  const auto nothing = std::numeric_limits<double>::infinity();
  Box all{Vec3::Constant(nothing), Vec3::Constant(-nothing)}, centres = all;
  for (auto t = begin; t != end; ++t) {
    const Vec3 centre = centre_of(*t);
    centres = {centres.lower.cwiseMin(centre), centres.upper.cwiseMax(centre)};
    for (const Vec3& corner : *t) all = {all.lower.cwiseMin(corner), all.upper.cwiseMax(corner)};
  }
  if (count <= most_in_leaf) {
    nodes_[node].first = first, nodes_[node].count = count;
    return all;
  }
  Eigen::Index axis = 0;
  centres.size().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end,
                   [axis](const auto& a, const auto& b) { return centre_of(a)[axis] < centre_of(b)[axis]; });
  const std::size_t children = nodes_.size();
  nodes_[node].first = static_cast<std::uint32_t>(children);
  nodes_.resize(children + 2);
  const std::array<Box, 2> halves{divide(children, first, half), divide(children + 1, first + half, count - half)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t which = 0; which < 2; ++which) {  // corners came from floats
      const auto along = static_cast<Eigen::Index>(i);
      nodes_[node].lower[i][which] = static_cast<float>(halves[which].lower[along]);
      nodes_[node].upper[i][which] = static_cast<float>(halves[which].upper[along]);
    }
  return all;
}

std::array<double, 2> TriangleTree::squares_to_halves(const Node& node, const Vec3& point) {
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eigen::Array2d at = Eigen::Array2d::Constant(point[static_cast<Eigen::Index>(axis)]);
    const Eigen::Array2d lower(node.lower[axis][0], node.lower[axis][1]),
        upper(node.upper[axis][0], node.upper[axis][1]);
    const Eigen::Array2d out = (lower - at).max(at - upper).max(0.0);
    sum += out * out;
  }
  return {sum[0], sum[1]};
}

TriangleTree::Place TriangleTree::nearest(const Vec3& point, std::uint32_t perhaps) const {
  const auto place_on = [&](std::uint32_t triangle) {
    const auto& [a, b, c] = triangles_[triangle];
    return nearest_place(point, a, b, c);
  };
  Place best{place_on(perhaps), perhaps};
  double least = (best.at - point).squaredNorm();
  struct Open {
    double square;
    std::uint32_t node;
  };
  std::array<Open, deepest> open;
  std::size_t count = 0;
  for (open[count++] = {0, 0}; count > 0;) {
    const Open here = open[--count];
    if (!(here.square < least)) continue;
    const Node& node = nodes_[here.node];
    for (std::uint32_t triangle = node.first; triangle < node.first + node.count; ++triangle) {
      const Vec3 place = place_on(triangle);
      const double square = (place - point).squaredNorm();
      if (square < least) least = square, best = {place, triangle};
    }
    if (node.count > 0) continue;
    const std::array<double, 2> squares = squares_to_halves(node, point);
    Open near{squares[0], node.first}, far{squares[1], node.first + 1};
    if (far.square < near.square) std::swap(near, far);
    if (far.square < least) open[count++] = far;
    if (near.square < least) open[count++] = near;
  }
  return best;
}

int TriangleTree::turns(const Vec3& point, bool from_above) const {
  const double x = point.x(), y = point.y(), z = point.z();
  int sum = 0;
  std::array<std::uint32_t, deepest> open;
  std::size_t count = 0;
  for (open[count++] = 0; count > 0;) {
    const Node& node = nodes_[open[--count]];
    for (std::uint32_t triangle = node.first; triangle < node.first + node.count; ++triangle) {
      const auto& [a, b, c] = triangles_[triangle];
      const int turn = passes(a, b, x, y) + passes(b, c, x, y) + passes(c, a, x, y);
      if (turn != 0 && (height_at(a, b, c, x, y) > z) == from_above) sum += turn;
    }
    if (node.count > 0) continue;
    for (std::uint32_t half = 0; half < 2; ++half) {
      const bool aside = x < node.lower[0][half] || x > node.upper[0][half] || y < node.lower[1][half] ||
                         y > node.upper[1][half] || (from_above ? node.upper[2][half] < z : node.lower[2][half] > z);
      if (!aside) open[count++] = node.first + half;
    }
  }
  return from_above ? -sum : sum;
}

}  // namespace fieldfab
