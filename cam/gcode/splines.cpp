#include "splines.h"

#include <cmath>

#include "base/chords.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr int deepest_halving = 16;
constexpr std::size_t most_points = 100'000;

/// Bisects a curve until three inner points are near enough to the chord.
template <class Curve>
void bisect(const Curve& curve, double from, const Vec2& begin, double to, const Vec2& end, int depth,
            const PointSink& give) {
  const Vec2 chord = end - begin;
  const double length = chord.norm();
  bool near = depth < deepest_halving - 2;  // at least four pieces
  for (const double share : {0.25, 0.5, 0.75}) {
    const Vec2 off = curve(from + share * (to - from)) - begin;
    const double along = length > 0 ? off.dot(chord) / length : 0;
    const double aside = length > 0 ? std::abs(off.x() * chord.y() - off.y() * chord.x()) / length : off.norm();
    near = near && aside <= chord_tolerance && along >= -chord_tolerance && along <= length + chord_tolerance;
  }
  if (near || depth == 0) return give(end);
  const double middle = (from + to) / 2;
  const Vec2 at = curve(middle);
  bisect(curve, from, begin, middle, at, depth - 1, give);
  bisect(curve, middle, at, to, end, depth - 1, give);
}

}  // namespace

void flatten(const std::array<Vec2, 4>& p, const PointSink& give) {
  const auto curve = [&](double t) -> Vec2 {
    const double s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
  };
  bisect(curve, 0, p[0], 1, p[3], deepest_halving, give);
}

void Nurbs::set_order(int order) {
  if (order < 2 || order > 32) refuse("a NURBS of order {}", order);
  order_ = static_cast<std::size_t>(order);
}

void Nurbs::add(const Vec2& point, double weight) {
  if (points_.size() >= most_points) refuse("more than {} control points", most_points);
  points_.push_back({point.x(), point.y(), weight});
}

/// A point of the curve by de Boor's algorithm, in homogeneous coordinates.
Vec2 Nurbs::at(std::size_t span, double parameter, std::vector<std::array<double, 3>>& work) const {
  const std::size_t spans = points_.size() - order_ + 1;
  const auto knot = [&](std::size_t i) {
    return i < order_ ? 0.0 : static_cast<double>(std::min(i - order_ + 1, spans));
  };
  for (std::size_t i = 0; i < order_; ++i) {
    const auto& [x, y, w] = points_[span + i];
    work[i] = {x * w, y * w, w};
  }
  for (std::size_t round = 1; round < order_; ++round)
    for (std::size_t i = order_ - 1; i >= round; --i) {
      const std::size_t k = span + i;
      const double low = knot(k), high = knot(k + order_ - round), share = (parameter - low) / (high - low);
      for (std::size_t c = 0; c < 3; ++c) work[i][c] += (share - 1) * (work[i][c] - work[i - 1][c]);
    }
  const auto& end = work[order_ - 1];
  return {end[0] / end[2], end[1] / end[2]};
}

void Nurbs::flatten(const PointSink& give) const {
  if (points_.size() < order_)
    refuse("a NURBS of order {} needs as many control points; there are {}", order_, points_.size());
  const std::size_t spans = points_.size() - order_ + 1;
  std::vector<std::array<double, 3>> work(order_);
  Vec2 begin{points_.front()[0], points_.front()[1]};
  for (std::size_t span = 0; span < spans; ++span) {
    const double from = static_cast<double>(span), to = from + 1;
    const auto curve = [&](double t) { return at(span, t, work); };
    const Vec2 end = span + 1 == spans ? Vec2(points_.back()[0], points_.back()[1]) : curve(to);
    bisect(curve, from, begin, to, end, deepest_halving, give);
    begin = end;
  }
}

}  // namespace fieldfab::cam::gcode
