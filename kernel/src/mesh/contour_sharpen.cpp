#include "contour_sharpen.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace fieldfab::contouring {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = std::array<std::uint32_t, 3>;
using Position = std::array<float, 3>;

struct FloatBox {
  Position lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
  void add(const Position& p) {
    for (std::size_t i = 0; i < 3; ++i) lower[i] = std::min(lower[i], p[i]), upper[i] = std::max(upper[i], p[i]);
  }
  [[nodiscard]] bool meets(const FloatBox& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (upper[i] < other.lower[i] || other.upper[i] < lower[i]) return false;
    return true;
  }
};

/// The triangles that wishes concern, found by place.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<Wish>& wishes, double reach, const std::vector<SurfacePoint>& points, TriangleMesh& mesh)
      : points_(points), mesh_(mesh), cell_(4 * reach) {
    constexpr std::uint32_t no_wish = ~0U;
    std::vector<std::uint32_t> wish_of(mesh.vertices.size(), no_wish);
    fans_.resize(wishes.size());
    for (std::size_t i = 0; i < wishes.size(); ++i) wish_of[wishes[i].vertex] = static_cast<std::uint32_t>(i);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t vertex : mesh.triangles[t])
        if (wish_of[vertex] != no_wish) fans_[wish_of[vertex]].push_back(t);

    // A triangle may come to lie anywhere between where it is and where the wishes of its vertices would take it.
    const auto range = [&](std::uint32_t t) {
      FloatBox box;
      for (const std::uint32_t vertex : mesh.triangles[t]) {
        box.add(mesh.vertices[vertex]);
        if (wish_of[vertex] != no_wish) box.add(wishes[wish_of[vertex]].target);
      }
      return box;
    };
    for (const auto& fan : fans_)
      for (const std::uint32_t t : fan) for_cells(range(t), [&](std::uint64_t key) { triangles_in_.try_emplace(key); });
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for_cells(range(t), [&](std::uint64_t key) {
        if (const auto found = triangles_in_.find(key); found != triangles_in_.end()) found->second.push_back(t);
      });
  }

  /// Moves the wish's vertex to `target` if that keeps the mesh valid; puts it back otherwise.
  bool move(std::size_t wish, std::uint32_t vertex, const Position& target) {
    const Position before = std::exchange(mesh_.vertices[vertex], target);
    if (faces_out(fans_[wish]) && fits(fans_[wish])) return true;
    mesh_.vertices[vertex] = before;
    return false;
  }

 private:
  template <class Visit>
  void for_cells(const FloatBox& box, const Visit& visit) const {
    std::array<std::int64_t, 3> low, high;
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = static_cast<std::int64_t>(std::floor(box.lower[i] / cell_));
      high[i] = static_cast<std::int64_t>(std::floor(box.upper[i] / cell_));
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          visit((static_cast<std::uint64_t>(x) & 0x1fffff) << 42 | (static_cast<std::uint64_t>(y) & 0x1fffff) << 21 |
                (static_cast<std::uint64_t>(z) & 0x1fffff));
  }

  [[nodiscard]] FloatBox box_of(std::uint32_t t) const {
    FloatBox box;
    for (const std::uint32_t vertex : mesh_.triangles[t]) box.add(mesh_.vertices[vertex]);
    return box;
  }

  [[nodiscard]] Point point(std::uint32_t vertex) const {
    const Position& p = mesh_.vertices[vertex];
    return {p[0], p[1], p[2]};
  }

  /// No triangle may fold over or shrink to nothing: a fold would be valid by a hair only, and no better than what it replaces. A
  /// triangle faces out where it does so for the surface at one of its corners at least; at a crease they differ.
  [[nodiscard]] bool faces_out(const std::vector<std::uint32_t>& fan) const {
    const double least_area = 1e-8 * cell_ * cell_;
    for (const std::uint32_t t : fan) {
      std::array<Eigen::Vector3d, 3> corner;
      for (std::size_t i = 0; i < 3; ++i)
        corner[i] = Eigen::Vector3f(mesh_.vertices[mesh_.triangles[t][i]].data()).cast<double>();
      const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      const double doubled_area = normal.norm();
      if (doubled_area < least_area) return false;
      bool any = false, out = false;
      for (const std::uint32_t vertex : mesh_.triangles[t]) {
        if (vertex >= points_.size()) continue;
        any = true;
        out = out || points_[vertex].normal.cast<double>().dot(normal) > 0.3 * doubled_area;
      }
      if (any && !out) return false;
    }
    return true;
  }

  bool fits(const std::vector<std::uint32_t>& fan) {
    for (const std::uint32_t t : fan) {
      const Triangle& triangle = mesh_.triangles[t];
      if (CGAL::collinear(point(triangle[0]), point(triangle[1]), point(triangle[2]))) return false;
      const FloatBox box = box_of(t);
      near_.clear();
      for_cells(box, [&](std::uint64_t key) {
        if (const auto found = triangles_in_.find(key); found != triangles_in_.end())
          near_.insert(near_.end(), found->second.begin(), found->second.end());
      });
      std::sort(near_.begin(), near_.end());
      near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
      for (const std::uint32_t other : near_)
        if (other != t && box.meets(box_of(other)) && overlap(triangle, mesh_.triangles[other])) return false;
    }
    return true;
  }

  /// Whether two triangles of the mesh have more in common than their common vertices and the edge between those.
  [[nodiscard]] bool overlap(const Triangle& one, const Triangle& other) const {
    std::array<std::size_t, 3> common{};  // positions in `one` of the vertices that are also in `other`
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (std::find(other.begin(), other.end(), one[i]) != other.end()) common[count++] = i;
    const Kernel::Triangle_3 a(point(one[0]), point(one[1]), point(one[2]));
    const Kernel::Triangle_3 b(point(other[0]), point(other[1]), point(other[2]));
    if (count == 0) return CGAL::do_intersect(a, b);
    if (count == 1) {
      const std::size_t i = common[0];
      const auto j = static_cast<std::size_t>(std::find(other.begin(), other.end(), one[i]) - other.begin());
      const Kernel::Segment_3 facing_a(point(one[(i + 1) % 3]), point(one[(i + 2) % 3]));
      const Kernel::Segment_3 facing_b(point(other[(j + 1) % 3]), point(other[(j + 2) % 3]));
      return CGAL::do_intersect(facing_a, b) || CGAL::do_intersect(facing_b, a);
    }
    if (count == 3) return true;
    const std::size_t lone = 3 - common[0] - common[1];
    const std::uint32_t p = one[common[0]], q = one[common[1]];
    const std::uint32_t third = *std::find_if(other.begin(), other.end(), [&](std::uint32_t v) { return v != p && v != q; });
    const Point ends[2] = {point(p), point(q)};
    return CGAL::coplanar(ends[0], ends[1], point(one[lone]), point(third)) &&
           CGAL::coplanar_orientation(ends[0], ends[1], point(one[lone]), point(third)) == CGAL::POSITIVE;
  }

  const std::vector<SurfacePoint>& points_;
  TriangleMesh& mesh_;
  double cell_;
  std::vector<std::vector<std::uint32_t>> fans_;  ///< by wish: the triangles around its vertex
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> triangles_in_;
  std::vector<std::uint32_t> near_;
};

}  // namespace

void grant(const std::vector<Wish>& wishes, double reach, const std::vector<SurfacePoint>& points, TriangleMesh& mesh,
           Progress& progress) {
  if (wishes.empty()) return;
  Neighbourhood neighbourhood(wishes, reach, points, mesh);
  std::vector<std::size_t> open(wishes.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  // A wish may have to wait for its neighbour's; the last round settles for half the way.
  for (const float share : {1.0F, 1.0F, 0.5F}) {
    std::erase_if(open, [&](std::size_t i) {
      if (i % 64 == 0) progress.check();
      const Position& from = mesh.vertices[wishes[i].vertex];
      Position target = wishes[i].target;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (share < 1) target[axis] = from[axis] + share * (target[axis] - from[axis]);
      return neighbourhood.move(i, wishes[i].vertex, target);
    });
  }
}

}  // namespace fieldfab::contouring
