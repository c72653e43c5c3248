// Closed curves: area, containment, nesting.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fieldfab/cam/plan/plane.h"

namespace fieldfab::cam {

double Loop::area() const {
  double twice = 0;
  for (std::size_t i = 0, last = points.size() - 1; i < points.size(); last = i++) {
    // Relative to the first point, so that a loop far from the origin keeps its precision.
    const Vec2 a = points[last] - points[0], b = points[i] - points[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

double Loop::length() const {
  double sum = 0;
  for (std::size_t i = 0, last = points.size() - 1; i < points.size(); last = i++)
    sum += (points[i] - points[last]).norm();
  return sum;
}

Rectangle Loop::bounds() const {
  Rectangle box = Rectangle::nothing();
  for (const Vec2& p : points) box.add(p);
  return box;
}

bool Loop::encloses(const Vec2& p) const {
  bool inside = false;
  for (std::size_t i = 0, last = points.size() - 1; i < points.size(); last = i++) {
    const Vec2 &a = points[last], &b = points[i];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

namespace {

/// Edges of all loops, sorted into strips along x.
class Strips {
 public:
  struct Edge {
    Vec2 from, to;
    std::size_t loop;
  };

  explicit Strips(const Loops& loops) {
    Rectangle all = Rectangle::nothing();
    std::size_t edges = 0;
    for (const Loop& loop : loops) {
      edges += loop.points.size();
      for (const Vec2& p : loop.points) all.add(p);
    }
    strips_.resize(1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(edges)) * 4));
    low_ = all.lower.y();
    height_ = std::max(all.size().y(), 1e-9) / static_cast<double>(strips_.size());
    for (std::size_t i = 0; i < loops.size(); ++i)
      for (std::size_t k = 0, last = loops[i].points.size() - 1; k < loops[i].points.size(); last = k++) {
        const Vec2 &a = loops[i].points[last], &b = loops[i].points[k];
        for (std::size_t s = strip_of(std::min(a.y(), b.y())); s <= strip_of(std::max(a.y(), b.y())); ++s)
          strips_[s].push_back({a, b, i});
      }
  }

  /// First edge of another loop on the ray from `p` towards smaller x.
  [[nodiscard]] const Edge* left_of(const Vec2& p, std::size_t own) const {
    const Edge* nearest = nullptr;
    double best = -1e300;
    for (const Edge& e : strips_[strip_of(p.y())]) {
      if (e.loop == own || (e.from.y() > p.y()) == (e.to.y() > p.y())) continue;
      const double x = e.from.x() + (p.y() - e.from.y()) / (e.to.y() - e.from.y()) * (e.to.x() - e.from.x());
      if (x < p.x() && x > best) best = x, nearest = &e;
    }
    return nearest;
  }

 private:
  [[nodiscard]] std::size_t strip_of(double y) const {
    return std::min(strips_.size() - 1, static_cast<std::size_t>(std::max(0.0, (y - low_) / height_)));
  }
  std::vector<std::vector<Edge>> strips_;
  double low_ = 0, height_ = 1;
};

}  // namespace

std::vector<int> nesting(const Loops& loops) {
  const auto leftmost = [&](std::size_t i) {
    return *std::min_element(loops[i].points.begin(), loops[i].points.end(),
                             [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  };
  std::vector<Vec2> start;
  std::vector<bool> anticlockwise;
  for (std::size_t i = 0; i < loops.size(); ++i)
    start.push_back(leftmost(i)), anticlockwise.push_back(loops[i].area() > 0);

  // Loops from left to right: the first loop on the ray to the left either contains this loop, or
  // is a sibling with a known parent.
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return start[a].x() < start[b].x(); });
  const Strips strips(loops);
  std::vector<int> parent(loops.size(), -1);
  for (const std::size_t i : order) {
    const Strips::Edge* const edge = strips.left_of(start[i], i);
    if (edge == nullptr) continue;
    const bool downwards = edge->to.y() < edge->from.y();
    parent[i] = downwards == anticlockwise[edge->loop] ? static_cast<int>(edge->loop) : parent[edge->loop];
  }
  return parent;
}

}  // namespace fieldfab::cam
