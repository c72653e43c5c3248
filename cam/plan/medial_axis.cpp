// The medial axis from Boost's Voronoi diagram of the outline's edges.
#include "medial_axis.h"

#include <algorithm>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <map>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

using Segment = boost::polygon::segment_data<int>;
using IntPoint = boost::polygon::point_data<int>;
using Diagram = boost::polygon::voronoi_diagram<double>;

constexpr double steps_per_mm = 1e5;  // Boost requires integers; 20 m fit

class MedialAxis {
 public:
  MedialAxis(const Loops& loops, double tolerance) : distance_(outline_field(loops)), tolerance_(tolerance) {
    for (const Loop& loop : loops) {
      std::vector<Vec3> points;
      for (const Vec2& p : loop.points) points.emplace_back(p.x(), p.y(), 0);
      points.push_back(points.front());
      points = simplified(points, tolerance);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const IntPoint a = rounded(points[i]), b = rounded(points[i + 1]);
        if (a != b) segments_.emplace_back(a, b);
      }
    }
    boost::polygon::construct_voronoi(segments_.begin(), segments_.end(), &diagram_);
  }

  /// Branches of the axis inside the outline, from fork to fork.
  std::vector<Branch> branches() const {
    std::multimap<const Diagram::vertex_type*, const Diagram::edge_type*> at;
    for (const auto& edge : diagram_.edges())
      if (belongs(edge)) at.emplace(edge.vertex0(), &edge);
    std::map<const Diagram::edge_type*, bool> used;
    std::vector<Branch> found;
    const auto run_from = [&](const Diagram::edge_type* edge) {
      Branch branch;
      while (!used[edge]) {
        used[edge] = used[edge->twin()] = true;
        append(*edge, branch);
        const auto [first, last] = at.equal_range(edge->vertex1());
        const Diagram::edge_type* next = nullptr;
        for (auto it = first; it != last; ++it)
          if (!used[it->second]) next = it->second;
        if (next == nullptr || std::distance(first, last) != 2) break;  // an end or a fork
        edge = next;
      }
      found.push_back(std::move(branch));
    };
    for (const auto& [vertex, edge] : at)
      if (!used[edge] && at.count(vertex) != 2) run_from(edge);
    for (const auto& [vertex, edge] : at)
      if (!used[edge]) run_from(edge);  // closed branches
    return found;
  }

 private:
  static IntPoint rounded(const Vec3& p) {
    const Vec3 steps = p * steps_per_mm;
    if (!(steps.cwiseAbs().maxCoeff() < 2e9))
      throw Error(ErrorKind::bad_input, "outline", "outlines must lie within 20 m of the origin");
    return {static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y()))};
  }
  static Vec2 place(const IntPoint& p) { return Vec2(p.x(), p.y()) / steps_per_mm; }
  static Vec2 place(const Diagram::vertex_type& v) { return Vec2(v.x(), v.y()) / steps_per_mm; }

  [[nodiscard]] double depth(const Vec2& p) const { return -static_cast<double>(distance_->value({p.x(), p.y(), 0})); }

  /// Nearest point of a cell's site.
  [[nodiscard]] Vec2 foot(const Diagram::cell_type& cell, const Vec2& p) const {
    const Segment& s = segments_[cell.source_index()];
    const Vec2 a = place(s.low()), b = place(s.high());
    if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT) return a;
    if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT) return b;
    const Vec2 along = b - a;
    return a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
  }

  /// Whether an edge belongs to the medial axis rather than to the facets of a smooth outline: the
  /// directions to its two sites form an angle.
  [[nodiscard]] bool belongs(const Diagram::edge_type& edge) const {
    if (!edge.is_primary() || !edge.is_finite()) return false;
    const Vec2 a = place(*edge.vertex0()), b = place(*edge.vertex1());
    if (depth(0.5 * (a + b)) < tolerance_) return false;
    // Self-intersections of the outline corrupt the diagram: an edge whose distance from the
    // outline is wrong is dropped.
    for (const Vec2& p : {a, b})
      if (std::abs((foot(*edge.cell(), p) - p).norm() - std::abs(depth(p))) > 4 * tolerance_) return false;
    const auto angle = [&](const Vec2& p) {
      const Vec2 u = foot(*edge.cell(), p) - p, v = foot(*edge.twin()->cell(), p) - p;
      return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u.dot(v));
    };
    constexpr double least = to_radians(35);
    return std::max({angle(a), angle(b), angle(0.5 * (a + b))}) > least;
  }

  /// Adds the points of an edge, so close that the edge and its radius are straight between them, within the tolerance:
  /// halfway from a point to a line the edge is a parabola, and halfway between two points the radius is a hyperbola.
  void append(const Diagram::edge_type& edge, Branch& branch) const {
    const Vec2 a = place(*edge.vertex0()), b = place(*edge.vertex1());
    const auto add = [&](const Vec2& p) {
      if (branch.empty() || (branch.back().at - p).norm() > 1e-7) branch.push_back({p, std::max(0.0, depth(p))});
    };
    // Both curves bend most at their vertices, by 1 / height.
    const auto steps_of = [&](double length, double height) {
      return std::clamp(static_cast<int>(std::ceil(length / std::sqrt(8 * tolerance_ * std::max(height, tolerance_)))),
                        1, 1000);
    };
    add(a);
    const bool point_here = edge.cell()->contains_point();
    const Diagram::cell_type &point_cell = point_here ? *edge.cell() : *edge.twin()->cell(),
                             &other_cell = point_here ? *edge.twin()->cell() : *edge.cell();
    const Vec2 focus = foot(point_cell, a);
    if (edge.is_curved()) {
      const Vec2 start = place(segments_[other_cell.source_index()].low());
      const Vec2 along = (place(segments_[other_cell.source_index()].high()) - start).normalized();
      Vec2 across(-along.y(), along.x());
      double height = (focus - start).dot(across);
      if (height < 0) height = -height, across = -across;
      const double x0 = (focus - start).dot(along), from = (a - start).dot(along), to = (b - start).dot(along);
      const int steps = steps_of(std::abs(to - from), height);
      if (height > 1e-9)
        for (int i = 1; i < steps; ++i) {
          const double x = from + (to - from) * i / steps;
          add(start + x * along + ((x - x0) * (x - x0) + height * height) / (2 * height) * across);
        }
    } else if (point_here && other_cell.contains_point()) {
      const int steps = steps_of((b - a).norm(), 0.5 * (focus - foot(other_cell, a)).norm());
      for (int i = 1; i < steps; ++i) add(a + (b - a) * i / steps);
    }
    add(b);
  }

  FieldPtr distance_;
  double tolerance_;
  std::vector<Segment> segments_;
  Diagram diagram_;
};

}  // namespace

std::vector<Branch> medial_axis(const Loops& loops, double tolerance) {
  return MedialAxis(loops, tolerance).branches();
}

}  // namespace fieldfab::cam
