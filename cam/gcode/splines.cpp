// G5, G5.1 and G5.2 to G5.3: curves in X and Y, approximated by short straight feeds.
#include <cmath>

#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr double chord_tolerance = 0.001;  // mm; greatest distance of the curve from its feeds
constexpr int deepest_halving = 16;
constexpr std::size_t most_points = 100'000;

/// Bisects a curve until three inner points are near enough to the chord. Calls `give` for the end
/// of each piece.
template <class Curve, class Give>
void flatten(const Curve& curve, double from, const Vec2& begin, double to, const Vec2& end, int depth,
             const Give& give) {
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
  flatten(curve, from, begin, middle, at, depth - 1, give);
  flatten(curve, middle, at, to, end, depth - 1, give);
}

}  // namespace

/// G5 (cubic) and G5.1 (quadratic).
void Interpreter::spline() {
  const int code = block_.code(GGroup::motion) == Block::none ? modes_.motion : block_.code(GGroup::motion);
  no_compensation("G5");
  if (modes_.plane != ArcPlane::xy) refuse("splines are of the plane G17");
  if (block_.has_any("zabcuvw")) refuse("a spline moves X and Y only");
  if (block_.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  require_feed();
  const AxisValues to = target();
  const Vec2 begin{at_.at[0], at_.at[1]}, end{to.at[0], to.at[1]};
  std::array<Vec2, 4> p;
  p[0] = begin, p[3] = end;
  if (code == 51) {
    if (!block_.has('i') || !block_.has('j')) refuse("G5.1 needs I and J");
    const Vec2 middle = begin + Vec2(length(block_['i']), length(block_['j']));
    p[1] = begin + (middle - begin) * (2.0 / 3), p[2] = end + (middle - end) * (2.0 / 3);
    last_control_.reset();
  } else {
    if (!block_.has('p') || !block_.has('q')) refuse("G5 needs P and Q");
    if (block_.has('i') != block_.has('j')) refuse("G5 needs both I and J, or neither");
    if (block_.has('i'))
      p[1] = begin + Vec2(length(block_['i']), length(block_['j']));
    else if (last_control_)
      p[1] = 2 * begin - *last_control_;
    else
      refuse("the first G5 of a row needs I and J");
    p[2] = end + Vec2(length(block_['p']), length(block_['q']));
    last_control_ = p[2];
  }
  const auto curve = [&](double t) -> Vec2 {
    const double s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
  };
  flatten(curve, 0, begin, 1, end, deepest_halving, [&](const Vec2& place) {
    AxisValues next = at_;
    next.at[0] = place.x(), next.at[1] = place.y();
    move(Motion::Kind::feed, next);
  });
}

/// G5.2 and the lines after it: control points of a NURBS curve. The first one is the tool's
/// position.
void Interpreter::nurbs_point() {
  no_compensation("G5.2");
  if (modes_.plane != ArcPlane::xy) refuse("splines are of the plane G17");
  if (block_.has_any("zabcuvw") || block_.machine_coordinates) refuse("a NURBS moves X and Y only");
  if (nurbs_order_ == 0) {
    require_feed();
    nurbs_order_ = 3;
    control_points_.assign(1, {at_.at[0], at_.at[1], 1});
  }
  if (block_.has('l')) {
    nurbs_order_ = whole(block_['l']);
    if (nurbs_order_ < 2 || nurbs_order_ > 32) refuse("a NURBS of order {}", nurbs_order_);
  }
  const double weight = block_.has('p') ? block_['p'] : 1;
  if (!(weight > 0)) refuse("a control point with the weight {}", weight);
  if (!block_.has('x') && !block_.has('y')) {
    control_points_.front()[2] = weight;
    return;
  }
  if (!block_.has('p')) refuse("each control point needs its weight P, above 0");
  if (!block_.has('x') || !block_.has('y')) refuse("each control point needs both X and Y");
  const AxisValues to = target();
  if (control_points_.size() >= most_points) refuse("more than {} control points", most_points);
  control_points_.push_back({to.at[0], to.at[1], weight});
}

void Interpreter::nurbs_end() {
  if (nurbs_order_ == 0) refuse("G5.3 without G5.2");
  const auto order = static_cast<std::size_t>(nurbs_order_);
  const std::vector<std::array<double, 3>> points = std::move(control_points_);
  nurbs_order_ = 0;
  control_points_.clear();
  modes_.motion = 800;
  if (points.size() < order)
    refuse("a NURBS of order {} needs as many control points; there are {}", order, points.size());
  // Uniform knot vector with end knots of multiplicity equal to the order.
  const std::size_t spans = points.size() - order + 1;
  const auto knot = [&](std::size_t i) {
    return i < order ? 0.0 : static_cast<double>(std::min(i - order + 1, spans));
  };
  std::vector<std::array<double, 3>> work(order);
  // de Boor's algorithm, in homogeneous coordinates
  const auto curve_in = [&](std::size_t span, double t) -> Vec2 {
    for (std::size_t i = 0; i < order; ++i) {
      const auto& [x, y, w] = points[span + i];
      work[i] = {x * w, y * w, w};
    }
    for (std::size_t round = 1; round < order; ++round)
      for (std::size_t i = order - 1; i >= round; --i) {
        const std::size_t k = span + i;
        const double low = knot(k), high = knot(k + order - round), share = (t - low) / (high - low);
        for (std::size_t c = 0; c < 3; ++c) work[i][c] += (share - 1) * (work[i][c] - work[i - 1][c]);
      }
    const auto& end = work[order - 1];
    return {end[0] / end[2], end[1] / end[2]};
  };
  const AxisValues start = at_;
  Vec2 begin{points[0][0], points[0][1]};
  for (std::size_t span = 0; span < spans; ++span) {
    const double from = static_cast<double>(span), to = from + 1;
    const auto curve = [&](double t) { return curve_in(span, t); };
    const Vec2 end = span + 1 == spans ? Vec2(points.back()[0], points.back()[1]) : curve(to);
    flatten(curve, from, begin, to, end, deepest_halving, [&](const Vec2& place) {
      AxisValues next = start;
      next.at[0] = place.x(), next.at[1] = place.y();
      move(Motion::Kind::feed, next);
    });
    begin = end;
  }
}

}  // namespace fieldfab::cam::gcode
