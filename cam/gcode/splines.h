// Curves of G5 to G5.3 in X and Y, approximated by chords.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fieldfab/cam/base/units.h"

namespace fieldfab::cam::gcode {

/// Receives the ends of chords.
using PointSink = std::function<void(const Vec2&)>;

/// Approximates a cubic Bezier curve within 0.001 mm. `control`: its ends, and the control points between them.
void flatten(const std::array<Vec2, 4>& control, const PointSink& give);

/// A NURBS curve. Its knots are uniform; those of the ends have the multiplicity of the order.
class Nurbs {
 public:
  /// A curve of order 3 (quadratic) from a point with the weight 1.
  explicit Nurbs(const Vec2& start) : points_{{start.x(), start.y(), 1}} {}

  /// Throws Refusal for an order outside of 2 to 32.
  void set_order(int order);
  void set_first_weight(double weight) { points_.front()[2] = weight; }
  /// Appends a control point. Throws Refusal beyond 100000 points.
  void add(const Vec2& point, double weight);
  /// Approximates the curve within 0.001 mm. Throws Refusal if there are fewer points than the order.
  void flatten(const PointSink& give) const;

 private:
  [[nodiscard]] Vec2 at(std::size_t span, double parameter, std::vector<std::array<double, 3>>& work) const;

  std::size_t order_ = 3;
  std::vector<std::array<double, 3>> points_;  // x, y, weight
};

}  // namespace fieldfab::cam::gcode
