/// Bounding volume hierarchy of triangles, for nearest points and ray casting; private to the mesh
/// folder.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Returns the corners of each triangle.
std::vector<std::array<Vec3, 3>> corners_of_all(const TriangleMesh& mesh);

/// Returns the mean of the corners.
inline Vec3 centre_of(const std::array<Vec3, 3>& triangle) { return (triangle[0] + triangle[1] + triangle[2]) / 3; }

/// Whether a triangle and a box have a common point (separating axis theorem).
bool meet(const std::array<Vec3, 3>& triangle, const Box& box);

class TriangleTree {
 public:
  /// A point of a triangle; triangles are numbered in the order of the tree.
  struct Place {
    Vec3 at = Vec3::Zero();
    std::uint32_t triangle = 0;
  };

  /// Precondition: the mesh has at least one triangle, and all vertices are finite.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Returns the point of the triangles that is nearest to `point`. The search starts at triangle
  /// `perhaps`, which should be near; any will do.
  [[nodiscard]] Place nearest(const Vec3& point, std::uint32_t perhaps = 0) const;

  /// Returns the signed number of triangles that the line along z through a point crosses on its
  /// way there, from above or from below. For a closed mesh this is exactly the winding number; for
  /// a point on the surface, that of a point next to it. Numbers of parts of a closed mesh may be
  /// added.
  [[nodiscard]] int turns(const Vec3& point, bool from_above) const;

  /// Calls visit(triangle) for each triangle that meets a box, until it returns false.
  template <class Visit>
  void visit_in(const Box& box, const Visit& visit) const {
    std::array<std::uint32_t, deepest> open;
    std::size_t count = 0;
    for (open[count++] = 0; count > 0;) {
      const Node& node = nodes_[open[--count]];
      for (std::uint32_t triangle = node.first; triangle < node.first + node.count; ++triangle)
        if (meet(triangles_[triangle], box) && !visit(triangle)) return;
      if (node.count > 0) continue;
      for (std::uint32_t half = 0; half < 2; ++half) {
        bool apart = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto a = static_cast<Eigen::Index>(axis);
          apart = apart || node.lower[axis][half] > box.upper[a] || node.upper[axis][half] < box.lower[a];
        }
        if (!apart) open[count++] = node.first + half;
      }
    }
  }

  [[nodiscard]] const std::array<Vec3, 3>& corners(std::uint32_t triangle) const { return triangles_[triangle]; }

 private:
  static constexpr std::size_t deepest = 64;  // depth of a tree of 2^32 triangles

  /// An inner node has its halves at `first` and the next index, and their boxes: by axis and half, so that both are
  /// compared with a point at once. A leaf has `count` triangles from `first` on.
  struct Node {
    std::array<std::array<float, 2>, 3> lower, upper;
    std::uint32_t first = 0, count = 0;
  };
  /// Returns the box of the node.
  Box divide(std::size_t node, std::uint32_t first, std::uint32_t count);
  /// Squares of the distances of a point from the boxes of a node's halves.
  static std::array<double, 2> squares_to_halves(const Node& node, const Vec3& point);

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Node> nodes_;
};

/// Returns the point of a triangle nearest to `point`; infinite if the triangle has no area, since
/// its edges belong to other triangles, too.
inline Vec3 nearest_place(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  // The projection onto the plane if it lies inside the triangle, otherwise the nearest point of
  // the edges that the point lies beyond.
  const Vec3 ab = b - a, ac = c - a, ap = point - a, normal = ab.cross(ac);
  const double square = normal.squaredNorm(), u = normal.dot(ap.cross(ac)), v = normal.dot(ab.cross(ap));
  if (!(square > 0)) return Vec3::Constant(std::numeric_limits<double>::infinity());
  if (u >= 0 && v >= 0 && u + v <= square) return point - (normal.dot(ap) / square) * normal;
  Vec3 best = a;
  double least = std::numeric_limits<double>::infinity();
  const auto try_edge = [&](const Vec3& from, const Vec3& way) {
    const double length = way.squaredNorm();
    const double t = length > 0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0.0;
    const Vec3 place = from + t * way;
    const double away = (point - place).squaredNorm();
    if (away < least) least = away, best = place;
  };
  if (v < 0) try_edge(a, ab);
  if (u < 0) try_edge(a, ac);
  if (u + v > square) try_edge(b, c - b);
  return best;
}

/// Returns 1 or -1, by the edge's direction, if the line along z through (x, y) has the edge beyond
/// it along y, otherwise 0. The sum over a triangle's edges tells whether the line crosses it, and
/// in which direction. The triangle on the other side of an edge gets the opposite number in spite
/// of rounding, so that each line leaves a closed mesh again.
inline int passes(const Vec3& a, const Vec3& b, double x, double y) {
  if ((a.x() <= x) == (b.x() <= x)) return 0;
  const bool forwards = a.x() <= x;
  const Vec3 &left = forwards ? a : b, &right = forwards ? b : a;
  const double side = (right.x() - left.x()) * (y - left.y()) - (right.y() - left.y()) * (x - left.x());
  return side < 0 ? (forwards ? 1 : -1) : 0;
}

/// Height at which the line crosses the triangle's plane; clamped to the heights of the triangle,
/// also if the triangle is vertical.
inline double height_at(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y) {
  const Vec3 cross = (b - a).cross(c - a);
  const double low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
  const double plane = a.z() - (cross.x() * (x - a.x()) + cross.y() * (y - a.y())) / cross.z();
  return plane >= low ? std::min(plane, high) : low;  // low also for NaN
}

}  // namespace fieldfab
