#include "fieldfab/field/plane_bounds.h"

#include <algorithm>
#include <cmath>

namespace fieldfab {

PlaneBounds plane_bounds(const Field& field, const Box& box) noexcept {
  static const std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  PlaneBounds bounds;
  bounds.centre = box.centre();
  bounds.half = 0.5 * box.size();
  field.slopes(box, axes, bounds.slopes);
  bounds.value = field.value(bounds.centre);
  // Values are computed in single precision at points rounded to it.
  constexpr double rounding = 1e-6;
  double reach = std::abs(bounds.value);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const Interval& slope = bounds.slopes[i];
    if (slope.maybe_nan) return bounds;
    const double low = slope.lower, high = slope.upper;
    bounds.slope[axis] = 0.5 * (low + high);
    bounds.error += 0.5 * (high - low) * bounds.half[axis];
    reach += std::max(std::abs(low), std::abs(high)) * (std::abs(bounds.centre[axis]) + bounds.half[axis]);
  }
  bounds.error += rounding * reach;
  bounds.known = std::isfinite(bounds.value) && std::isfinite(bounds.error) && bounds.slope.allFinite();
  return bounds;
}

}  // namespace fieldfab
