/// Triangles sorted into boxes within boxes, to ask which is nearest and which a line passes; private to the mesh folder.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// The corners of each triangle.
std::vector<std::array<Vec3, 3>> corners_of_all(const TriangleMesh& mesh);

/// Whether a triangle and a box have a point in common: no plane that a face or edges of them span parts them.
bool meet(const std::array<Vec3, 3>& triangle, const Box& box);

class TriangleTree {
 public:
  /// A place of a triangle; the triangle counts in the tree's own order.
  struct Place {
    Vec3 at = Vec3::Zero();
    std::uint32_t triangle = 0;
  };

  /// Of a mesh with one triangle or more, of finite places.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// The place of the triangles that is nearest to a point. The search begins with a triangle that may be near (any will do).
  [[nodiscard]] Place nearest(const Vec3& point, std::uint32_t perhaps = 0) const;

  /// How often the line through a point along z passes triangles on its way there, from above or from below: of a closed mesh it
  /// is how often that winds around the point, exactly; on its surface, around some place next to it. Sums over parts of a closed
  /// mesh are as good.
  [[nodiscard]] int turns(const Vec3& point, bool from_above) const;

  /// Calls visit(triangle) for each triangle that meets a box, until it returns false.
  template <class Visit>
  void visit_in(const Box& box, const Visit& visit) const {
    std::array<std::uint32_t, deepest> open;
    std::size_t count = 0;
    for (open[count++] = 0; count > 0;) {
      const Node& node = nodes_[open[--count]];
      bool apart = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        apart = apart || node.lower[axis] > box.upper[a] || node.upper[axis] < box.lower[a];
      }
      if (apart) continue;
      for (std::uint32_t triangle = node.first; triangle < node.first + node.count; ++triangle)
        if (meet(triangles_[triangle], box) && !visit(triangle)) return;
      if (node.count > 0) continue;
      open[count++] = node.first;
      open[count++] = node.first + 1;
    }
  }

  [[nodiscard]] const std::array<Vec3, 3>& corners(std::uint32_t triangle) const { return triangles_[triangle]; }

 private:
  static constexpr std::size_t deepest = 64;  // halves of 2^32 triangles

  /// Its two halves are at `first` and the one after, or its triangles from `first` on, where it has a count of them.
  struct Node {
    std::array<float, 3> lower, upper;
    std::uint32_t first = 0, count = 0;
  };
  void divide(std::size_t node, std::uint32_t first, std::uint32_t count);

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Node> nodes_;
};

/// The place of a triangle that is nearest to a point; far away where it has no area, since its edges are others', too.
inline Vec3 nearest_place(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  // The plane's foot if it lies within the triangle, else the nearest place of the edges that the point lies beyond.
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

/// Whether the line in z through (x, y) has the edge beyond it along y, 1 or -1 by the edge's direction: summed over a triangle's
/// edges it tells whether the line passes it, and which way. An edge gives what it takes for the triangle on its other side,
/// whatever rounding does, so that every line comes out of a closed mesh again.
inline int passes(const Vec3& a, const Vec3& b, double x, double y) {
  if ((a.x() <= x) == (b.x() <= x)) return 0;
  const bool forwards = a.x() <= x;
  const Vec3 &left = forwards ? a : b, &right = forwards ? b : a;
  const double side = (right.x() - left.x()) * (y - left.y()) - (right.y() - left.y()) * (x - left.x());
  return side < 0 ? (forwards ? 1 : -1) : 0;
}

/// Where that line passes the triangle's plane; within the triangle's heights, also where it stands upright.
inline double height_at(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y) {
  const Vec3 cross = (b - a).cross(c - a);
  const double low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
  const double plane = a.z() - (cross.x() * (x - a.x()) + cross.y() * (y - a.y())) / cross.z();
  return plane >= low ? std::min(plane, high) : low;  // low also for NaN
}

}  // namespace fieldfab
