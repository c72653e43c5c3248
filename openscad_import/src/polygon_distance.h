/// Distance to the outlines of a flat shape.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fieldfab/core/interval.h"
#include "flat.h"

namespace fieldfab::openscad {

/// Exact signed distance to outlines in the plane, mm, negative inside. The nearest edge decides
/// the side; if a corner is nearest, the edge at the corner that faces the point most directly.
class PolygonDistance {
 public:
  explicit PolygonDistance(const Region& region);

  struct Nearest {
    double distance = 0;
    Vec2 slope = Vec2::Zero();  ///< of the distance at the point
  };
  [[nodiscard]] Nearest at(const Vec2& point) const;

  /// Returns an object with the same results, bit for bit, for all points within `reach` of
  /// `centre`; null if that is this object. Sets `distance` to the distance at the centre.
  [[nodiscard]] std::shared_ptr<const PolygonDistance> near(const Vec2& centre, double reach, double& distance) const;

  /// Returns bounds on the rate of change of the distance along each direction, between points
  /// within `reach` of `centre` (Field::slopes()).
  void slopes(const Vec2& centre, double reach, std::span<const Vec2> directions, std::span<Interval> out) const;

  [[nodiscard]] std::size_t edges() const { return edges_.size(); }
  /// Approximate cost of at(), in arithmetic operations.
  [[nodiscard]] std::size_t cost() const;

 private:
  struct Edge {
    Vec2 from, to;
  };
  struct Group {
    Vec2 lower, upper;
    std::uint32_t first, count;  ///< of the edges
    std::uint32_t second = 0;    ///< index of the second half, or 0 if undivided; the first half follows this node
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
