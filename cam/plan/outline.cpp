// Signed distance to closed curves, by a bounding box tree of their edges.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

class OutlineField final : public Field {
 public:
  explicit OutlineField(const Loops& loops) {
    std::size_t count = 0;
    for (const Loop& loop : loops) count += loop.points.size();
    edges_.reserve(count);
    for (const Loop& loop : loops)
      for (std::size_t k = 0, n = loop.points.size(); k < n; ++k)
        edges_.push_back({loop.points[k], loop.points[(k + 1) % n], static_cast<std::uint32_t>(edges_.size()), 0});
    if (edges_.empty()) return;
    grow(0, count);

    // grow() has reordered the edges; `before` still contains the original indices.
    std::vector<std::uint32_t> place(count);
    for (std::uint32_t i = 0; i < count; ++i) place[edges_[i].before] = i;
    std::size_t first = 0;
    for (const Loop& loop : loops) {
      const std::size_t n = loop.points.size();
      for (std::size_t k = 0; k < n; ++k) {
        Edge& e = edges_[place[first + k]];
        e.before = place[first + (k + n - 1) % n], e.after = place[first + (k + 1) % n];
      }
      first += n;
    }
    crossing_ = any_crossing();
  }

  void values(const Points& points, float* out) const noexcept override {
    Nearest nearest;
    for (std::size_t i = 0; i < points.count; ++i) {
      nearest = find({points.x[i], points.y[i]}, nearest.edge);
      out[i] = static_cast<float>(nearest.distance);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    Nearest nearest;
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec2 p(points.x[i], points.y[i]);
      nearest = find(p, nearest.edge);
      out[i] = static_cast<float>(nearest.distance);
      const Vec2 away = p - nearest.place;
      const double length = away.norm();
      // On the curve itself the gradient is the edge's normal.
      const Vec2 slope = length > 1e-6 * (1 + p.norm()) ? Vec2(away / std::copysign(length, nearest.distance))
                                                        : normal_of(nearest.edge);
      slopes.dx[i] = static_cast<float>(slope.x()), slopes.dy[i] = static_cast<float>(slope.y()), slopes.dz[i] = 0;
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    const Rectangle r = Rectangle::of(box);
    const double middle = find(0.5 * (r.lower + r.upper), 0).distance,
                 reach = 0.5 * r.size().norm() * (1 + 1e-6) + 1e-6;
    return {static_cast<float>(middle - reach), static_cast<float>(middle + reach), false};
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 100; }

 private:
  struct Edge {
    Vec2 from, to;
    std::uint32_t before, after;  // neighbours along the loop
    /// Unit normal to the right, away from the solid.
    [[nodiscard]] Vec2 normal() const {
      const Vec2 along = (to - from).normalized();
      return {along.y(), -along.x()};
    }
  };
  struct Node {
    Rectangle box;
    std::uint32_t first,
        // number of edges; 0 for a branch, whose first child follows it and whose second child is
        // at `first`
        count;
  };
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t edge = 0;
    Vec2 place = Vec2::Zero();
  };

  /// Appends the subtree of the edges [first, last), which it partitions.
  void grow(std::size_t first, std::size_t last) {
    const std::size_t here = nodes_.size();
    Rectangle box = Rectangle::nothing();
    for (std::size_t i = first; i < last; ++i) box.add(edges_[i].from), box.add(edges_[i].to);
    constexpr std::size_t leaf = 6;
    const bool small = last - first <= leaf;
    nodes_.push_back({box, static_cast<std::uint32_t>(first), small ? static_cast<std::uint32_t>(last - first) : 0});
    if (small) return;
    const int axis = box.size().x() > box.size().y() ? 0 : 1;
    const std::size_t middle = (first + last) / 2;
    const auto at = [&](std::size_t i) { return edges_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [axis](const Edge& a, const Edge& b) {
      return a.from[axis] + a.to[axis] < b.from[axis] + b.to[axis];
    });
    grow(first, middle);
    nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
    grow(middle, last);
  }

  static Vec2 closest_on(const Edge& e, const Vec2& p) {
    const Vec2 along = e.to - e.from;
    const double length = along.squaredNorm(), t = length > 0 ? (p - e.from).dot(along) / length : 0;
    return t <= 0 ? e.from : t >= 1 ? e.to : Vec2(e.from + t * along);
  }
  static double squared_distance(const Rectangle& box, const Vec2& p) {
    return (p - p.cwiseMax(box.lower).cwiseMin(box.upper)).squaredNorm();
  }
  [[nodiscard]] Vec2 normal_of(std::uint32_t edge) const {
    return edges_.empty() ? Vec2::Zero() : edges_[edge].normal();
  }

  /// Nearest point of the curves. `guess`: an edge that may be near.
  [[nodiscard]] Nearest find(const Vec2& p, std::uint32_t guess) const noexcept {
    Nearest nearest;
    if (edges_.empty()) return nearest;
    nearest.edge = guess;
    nearest.place = closest_on(edges_[guess], p);
    double best = (p - nearest.place).squaredNorm();
    struct Waiting {
      std::uint32_t node;
      double squared;
    };
    std::array<Waiting, 64> waiting;  // sufficient for 2^60 edges: each level adds one entry
    std::size_t count = 0;
    waiting[count++] = {0, squared_distance(nodes_[0].box, p)};
    while (count > 0) {
      const Waiting w = waiting[--count];
      if (w.squared > best) continue;
      const Node& node = nodes_[w.node];
      if (node.count == 0) {
        Waiting a{w.node + 1, squared_distance(nodes_[w.node + 1].box, p)},
            b{node.first, squared_distance(nodes_[node.first].box, p)};
        if (a.squared < b.squared) std::swap(a, b);
        if (a.squared <= best) waiting[count++] = a;
        if (b.squared <= best) waiting[count++] = b;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Vec2 place = closest_on(edges_[i], p);
        const double squared = (p - place).squaredNorm();
        // Ties are broken by the index, so that the result does not depend on the guess: where
        // curves cross, the sign depends on the edge.
        if (squared < best || (squared == best && i < nearest.edge))
          best = squared, nearest.edge = i, nearest.place = place;
      }
    }
    if (crossing_) {
      nearest.distance = winding(p) > 0 ? -std::sqrt(best) : std::sqrt(best);
      return nearest;
    }
    const Edge& e = edges_[nearest.edge];
    // At a vertex two edges are equally near: the sum of their normals determines the side.
    Vec2 normal = e.normal();
    if (nearest.place == e.from) normal += edges_[e.before].normal();
    if (nearest.place == e.to) normal += edges_[e.after].normal();
    nearest.distance = std::copysign(std::sqrt(best), normal.dot(p - nearest.place));
    return nearest;
  }

  /// Calls visit(edge) for the edges of all leaves in wanted boxes, until it returns false.
  template <class Wanted, class Visit>
  void each_edge(const Wanted& wanted, const Visit& visit) const {
    std::array<std::uint32_t, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const std::uint32_t here = waiting[--count];
      const Node& node = nodes_[here];
      if (!wanted(node.box)) continue;
      if (node.count == 0) {
        waiting[count++] = here + 1, waiting[count++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (!visit(i)) return;
    }
  }

  /// Twice the signed area of a triangle.
  static double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  /// Whether two edges meet except at common vertices of their loop. Where curves cross, the
  /// nearest edge does not determine the side.
  [[nodiscard]] bool any_crossing() const {
    std::atomic<bool> found{false};
    constexpr std::size_t portion = 4096;
    parallel_for((edges_.size() + portion - 1) / portion, [&](std::size_t k) {
      for (std::size_t i = k * portion; i < std::min(edges_.size(), (k + 1) * portion) && !found; ++i) {
        const Edge& e = edges_[i];
        Rectangle box = Rectangle::nothing();
        box.add(e.from), box.add(e.to);
        const auto overlaps = [&](const Rectangle& other) {
          return (other.lower.array() <= box.upper.array()).all() && (box.lower.array() <= other.upper.array()).all();
        };
        each_edge(overlaps, [&](std::uint32_t j) {
          if (j <= i || j == e.before || j == e.after) return true;
          const Edge& f = edges_[j];
          const bool apart = turn(e.from, e.to, f.from) * turn(e.from, e.to, f.to) > 0 ||
                             turn(f.from, f.to, e.from) * turn(f.from, f.to, e.to) > 0;
          Rectangle other = Rectangle::nothing();
          other.add(f.from), other.add(f.to);
          if (!apart && overlaps(other)) found = true;
          return !found;
        });
      }
    });
    return found;
  }

  /// Winding number of the curves about a point, anticlockwise.
  [[nodiscard]] int winding(const Vec2& p) const {
    int rounds = 0;
    each_edge(
        [&](const Rectangle& box) {
          return box.lower.y() <= p.y() && p.y() <= box.upper.y() && p.x() <= box.upper.x();
        },
        [&](std::uint32_t i) {
          const Edge& e = edges_[i];
          if (e.from.y() <= p.y() && p.y() < e.to.y() && turn(e.from, e.to, p) > 0) ++rounds;
          if (e.to.y() <= p.y() && p.y() < e.from.y() && turn(e.from, e.to, p) < 0) --rounds;
          return true;
        });
    return rounds;
  }

  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
  bool crossing_ = false;
};

}  // namespace

FieldPtr outline_field(const Loops& loops) { return std::make_shared<OutlineField>(loops); }

Loops offset(const Loops& loops, double distance, double cell, Progress& progress) {
  if (loops.empty()) return {};
  Rectangle region = Rectangle::nothing();
  for (const Loop& loop : loops)
    for (const Vec2& p : loop.points) region.add(p);
  return contours(*outline_field(loops), region.grown(std::max(0.0, distance) + cell), {cell, 0, distance}, progress);
}

}  // namespace fieldfab::cam
