#include "polygon_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "fieldfab/field/distance_slopes.h"

namespace fieldfab::openscad {
namespace {

constexpr std::uint32_t most_in_group = 6;

/// Square of the distance to a rectangle.
double square_distance(const Vec2& lower, const Vec2& upper, const Vec2& p) {
  return (lower - p).cwiseMax(p - upper).cwiseMax(0).squaredNorm();
}

}  // namespace

struct PolygonDistance::Found {
  double square = std::numeric_limits<double>::infinity();
  double across = 0;         ///< signed distance from the edge's line, positive to its left, inside the solid
  Vec2 to = Vec2::Zero();    ///< from the nearest point
  Vec2 left = Vec2::Zero();  ///< normal of the edge, into the solid
};

PolygonDistance::PolygonDistance(const Region& region) {
  for (const Outline& outline : region.outlines)
    for (std::size_t i = 0; i < outline.size(); ++i)
      if (const Edge edge{outline[i], outline[(i + 1) % outline.size()]}; edge.from != edge.to) edges_.push_back(edge);
  if (!edges_.empty()) divide(0, static_cast<std::uint32_t>(edges_.size()));
}

PolygonDistance::PolygonDistance(std::vector<Edge> edges) : edges_(std::move(edges)) {
  if (!edges_.empty()) divide(0, static_cast<std::uint32_t>(edges_.size()));
}

void PolygonDistance::divide(std::uint32_t first, std::uint32_t count) {
  const std::size_t here = groups_.size();
  const auto begin = edges_.begin() + first, end = begin + count;
  Group group{begin->from, begin->from, first, count};
  for (auto e = begin; e != end; ++e) {
    group.lower = group.lower.cwiseMin(e->from).cwiseMin(e->to);
    group.upper = group.upper.cwiseMax(e->from).cwiseMax(e->to);
  }
  groups_.push_back(group);
  if (count <= most_in_group) return;
  const Vec2 size = group.upper - group.lower;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const Edge& a, const Edge& b) {
    return a.from[axis] + a.to[axis] < b.from[axis] + b.to[axis];
  });
  divide(first, half);
  groups_[here].second = static_cast<std::uint32_t>(groups_.size());
  divide(first + half, count - half);
}

void PolygonDistance::look(const Edge& edge, const Vec2& point, Found& best) {
  const Vec2 along = edge.to - edge.from, from = point - edge.from;
  const double square = along.squaredNorm(), t = along.dot(from);
  // At a corner both edges must compute exactly the same distance.
  const Vec2 to = t <= 0 ? from : t >= square ? Vec2(point - edge.to) : Vec2(from - along * (t / square));
  const double distance = to.squaredNorm();
  if (distance > best.square) return;
  const double length = std::sqrt(square);
  const double across = (along.x() * from.y() - along.y() * from.x()) / length;
  if (distance == best.square && std::abs(across) <= std::abs(best.across)) return;
  best = {distance, across, to, Vec2(-along.y(), along.x()) / length};
}

PolygonDistance::Nearest PolygonDistance::at(const Vec2& point) const {
  Found best;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  if (!groups_.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t here = open[--count];
    const Group& group = groups_[here];
    if (square_distance(group.lower, group.upper, point) > best.square) continue;
    if (group.second == 0) {
      for (std::uint32_t i = group.first; i < group.first + group.count; ++i) look(edges_[i], point, best);
      continue;
    }
    const Group &one = groups_[here + 1], &two = groups_[group.second];
    const bool one_first = square_distance(one.lower, one.upper, point) <= square_distance(two.lower, two.upper, point);
    open[count++] = one_first ? group.second : here + 1;
    open[count++] = one_first ? here + 1 : group.second;
  }
  const double distance = std::sqrt(best.square), sign = best.across > 0 ? -1 : 1;
  // On the edge itself the direction from the nearest point is undefined; the normal is not.
  const bool touching = !(distance > 1e-9);
  return {sign * distance, touching ? Vec2(-best.left) : Vec2(best.to * (sign / distance))};
}

std::shared_ptr<const PolygonDistance> PolygonDistance::near(const Vec2& centre, double reach, double& distance) const {
  distance = at(centre).distance;
  std::vector<Edge> kept = within(centre, (std::abs(distance) + 2 * reach) * (1 + 1e-9) + 1e-9);
  if (kept.size() == edges_.size()) return nullptr;
  return std::shared_ptr<const PolygonDistance>(new PolygonDistance(std::move(kept)));
}

std::vector<PolygonDistance::Edge> PolygonDistance::within(const Vec2& centre, double reach) const {
  const double square = reach * reach;
  std::vector<Edge> kept;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  if (!groups_.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t here = open[--count];
    const Group& group = groups_[here];
    if (square_distance(group.lower, group.upper, centre) > square) continue;
    if (group.second != 0) {
      open[count++] = group.second;
      open[count++] = here + 1;
      continue;
    }
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      Found found;
      look(edges_[i], centre, found);
      if (found.square <= square) kept.push_back(edges_[i]);
    }
  }
  return kept;
}

void PolygonDistance::slopes(const Vec2& centre, double reach, std::span<const Vec2> directions,
                             std::span<Interval> out) const {
  std::fill_n(out.begin(), directions.size(), Interval::unknown());
  const double distance = at(centre).distance;
  if (!std::isfinite(distance) || !std::isfinite(reach)) return;
  const std::vector<Edge> near = within(centre, (std::abs(distance) + 2 * reach) * (1 + 1e-9) + 1e-9);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto steepest = static_cast<float>(directions[i].norm());
    out[i] = {-steepest, steepest, false};
  }
  constexpr std::size_t many = 64;
  if (near.empty() || near.size() > many) return;
  const auto in_space = [](const Vec2& v) { return Vec3(v.x(), v.y(), 0); };
  // The gradient is the normal of an edge, or at a corner any direction between the normals of its
  // edges.
  std::vector<std::array<Vec3, 2>> corners;
  std::vector<Vec3> ways;
  std::vector<double> reaches;
  for (const Edge& edge : near) {
    const auto outward = [&](const Edge& of) {
      const Vec2 along = (of.to - of.from).normalized();
      return Vec3(along.y(), -along.x(), 0);
    };
    bool any = false;
    for (const Edge& next : near)
      if (edge.to == next.from) corners.push_back({outward(edge), outward(next)}), any = true;
    if (!any) corners.push_back({outward(edge), outward(edge)});
    // Off the outlines the gradient points away from the nearest point; beside the edge that is
    // along its normal.
    Found found;
    look(edge, centre, found);
    ways.push_back(distance < 0 ? Vec3(-in_space(found.to)) : in_space(found.to));
    const double length = (edge.to - edge.from).norm(), along = (edge.to - edge.from).dot(centre - edge.from) / length;
    reaches.push_back(along > reach && along < length - reach ? 0 : reach);
  }
  std::vector<NormalCone> cones;
  for (const std::array<Vec3, 2>& normals : corners) cones.emplace_back(normals);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec3 direction = in_space(directions[i]);
    const auto add = [](std::optional<Interval>& all, const Interval& one) {
      all = all ? Interval{std::min(all->lower, one.lower), std::max(all->upper, one.upper), false} : one;
    };
    std::optional<Interval> by_normals, by_ways;
    for (const NormalCone& cone : cones) add(by_normals, cone.along(direction));
    out[i] = common(out[i], *by_normals);
    if (std::abs(distance) <= reach) continue;
    for (std::size_t k = 0; k < ways.size(); ++k) add(by_ways, slope_away_from(ways[k], reaches[k], direction));
    out[i] = common(out[i], *by_ways);
  }
}

std::size_t PolygonDistance::cost() const {
  return 30 * std::min<std::size_t>(edges_.size(), 12 + 2 * static_cast<std::size_t>(std::bit_width(edges_.size())));
}

}  // namespace fieldfab::openscad
