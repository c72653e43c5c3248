/// Check that Field::slopes() contains difference quotients.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "fieldfab/field/field.h"

namespace fieldfab {

inline constexpr double last_place = 1.2e-7;  // machine epsilon of floats

/// A value with a bound of the rounding error relative to the Field's formula.
struct RoundedValue {
  double value;
  double rounding;
  double slope_rounding = 0;  ///< bound of the rounding error of slopes there
};

/// The Field's value, with a bound for several roundings of its coordinates and its value to
/// floats. For Fields with slopes of about 1 per mm at most.
inline RoundedValue rounded_value(const Field& field, const Vec3& p) {
  const double value = field.value(p);
  return {value, 32 * last_place * (1 + p.cwiseAbs().maxCoeff() + std::abs(value))};
}

/// Unit vectors, along the axes and random.
inline std::vector<Vec3> directions_for_slopes(std::size_t count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  while (directions.size() < count)
    directions.push_back(Vec3(normal(random), normal(random), normal(random)).normalized());
  return directions;
}

/// Checks difference quotients between random points of a box, at least a thousandth of its side
/// apart, against slopes(). `value` may return NaN for an unknown value. Returns the number of
/// directions with known slopes.
inline std::size_t expect_slopes_hold(const Field& field, const Box& box,
                                      const std::function<RoundedValue(const Vec3&)>& value) {
  constexpr std::size_t count = 11;  // more than are processed together
  const std::vector<Vec3> directions = directions_for_slopes(count);
  std::array<Interval, count> slopes;
  field.slopes(box, directions, slopes);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const double side = box.size().minCoeff();
  const auto steepest = [](const Interval& range) {
    return std::max(std::abs(double{range.lower}), std::abs(double{range.upper}));
  };
  std::size_t known = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Interval& slope = slopes[i];
    if (slope.maybe_nan) continue;
    ++known;
    for (int j = 0; j < 40; ++j) {
      const Vec3 p = box.lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.size());
      const Vec3 q = p + unit(random) * side * directions[i];
      const Vec3 from = p.cast<float>().cast<double>(), to = q.cast<float>().cast<double>();
      if (!box.contains(from) || !box.contains(to) || (to - from).norm() < 1e-3 * side) continue;
      const RoundedValue a = value(from), b = value(to);
      if (std::isnan(a.value) || std::isnan(b.value)) continue;
      // Rounding to floats turns the line slightly: the remainder is bounded by the slopes along
      // the axes.
      const double t = (to - from).dot(directions[i]);
      const Vec3 aside = to - from - t * directions[i];
      double sum = steepest(slope), rounding = a.rounding + b.rounding;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        rounding += std::abs(aside[k]) * steepest(slopes[axis]);
        sum += std::abs(directions[i][k]) * steepest(slopes[axis]);
      }
      rounding += t * std::max({8 * last_place * sum, a.slope_rounding, b.slope_rounding});
      if (b.value - a.value < t * slope.lower - rounding || b.value - a.value > t * slope.upper + rounding)
        RC_FAIL(fmt::format("a difference of {} for a step of {} is not in [{}, {}] times that; rounding {}",
                            b.value - a.value, t, slope.lower, slope.upper, rounding));
    }
  }
  return known;
}

inline std::size_t expect_slopes_hold(const Field& field, const Box& box) {
  return expect_slopes_hold(field, box, [&](const Vec3& p) { return rounded_value(field, p); });
}

}  // namespace fieldfab
