/// How far it is to the outlines of a flat shape.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fieldfab/core/interval.h"
#include "flat.h"

namespace fieldfab::openscad {

/// The signed distance to outlines in the plane, mm, negative inside: exact. Which side a point is on the nearest edge tells;
/// where that is a corner, the one of its edges that is seen the least from the side.
class PolygonDistance {
 public:
  explicit PolygonDistance(const Region& region);

  struct Nearest {
    double distance = 0;
    Vec2 slope = Vec2::Zero();  ///< of the distance there
  };
  [[nodiscard]] Nearest at(const Vec2& point) const;

  /// What answers alike, bit for bit, for all points within `reach` of `centre`; null where that is this one. `distance` is set
  /// to that at the centre.
  [[nodiscard]] std::shared_ptr<const PolygonDistance> near(const Vec2& centre, double reach, double& distance) const;

  /// Bounds on how fast the distance changes along each direction between points within `reach` of `centre` (Field::slopes()).
  void slopes(const Vec2& centre, double reach, std::span<const Vec2> directions, std::span<Interval> out) const;

  [[nodiscard]] std::size_t edges() const { return edges_.size(); }
  /// Rough cost of at(), in arithmetic operations.
  [[nodiscard]] std::size_t cost() const;

 private:
  struct Edge {
    Vec2 from, to;
  };
  struct Group {
    Vec2 lower, upper;
    std::uint32_t first, count;  ///< of the edges
    std::uint32_t second = 0;    ///< the other half; the first follows at once. 0 where it is not divided
  };
  struct Found;
  explicit PolygonDistance(std::vector<Edge> edges);
  void divide(std::uint32_t first, std::uint32_t count);
  [[nodiscard]] std::vector<Edge> within(const Vec2& centre, double reach) const;
  static void look(const Edge& edge, const Vec2& point, Found& best);

  std::vector<Edge> edges_;
  std::vector<Group> groups_;
};

}  // namespace fieldfab::openscad
