#include "hidden_parts.h"

#include <algorithm>
#include <limits>

#include "fieldfab/field/plane_bounds.h"

namespace fieldfab::cam {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// Whether no point of the interval is inside; NaN and 0 are outside.
bool holds_nothing(const Interval& range) { return range.lower >= 0; }

/// Samples (left, low) to (right, high) of a lattice, inclusive.
struct Samples {
  const HeightMap& heights;
  int left, low, right, high;

  [[nodiscard]] std::pair<float, float> range() const {
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (int row = low; row <= high; ++row) {
      const auto [a, b] = std::minmax_element(heights.row(row) + left, heights.row(row) + right + 1);
      least = std::min(least, *a), most = std::max(most, *b);
    }
    return {least, most};
  }

  /// Whether the solid lies below a plane that rises at most `slack` above the samples.
  [[nodiscard]] bool under_plane(const PlaneBounds& plane, double slack) const {
    if (!(plane.slope.z() > 0)) return false;
    for (int row = low; row <= high; ++row)
      for (int column = left; column <= right; ++column) {
        const Vec2 offset = heights.place(column, row) - plane.centre.head<2>();
        const double z =
            plane.centre.z() + (plane.error - plane.value - plane.slope.head<2>().dot(offset)) / plane.slope.z();
        if (z > static_cast<double>(heights.at(column, row)) + slack) return false;
      }
    return true;
  }
};

/// Lowers the top of a box that is taller than wide as long as its upper half contains nothing. Boxes without width, at
/// the ends of the bounds, stay.
void lower_top(const Field& field, Box& box) {
  const double width = box.size().head<2>().maxCoeff();
  while (width > 0 && box.size().z() > width) {
    Box upper = box;
    upper.lower.z() = box.centre().z();
    if (!holds_nothing(field.interval(upper))) return;
    box.upper.z() = upper.lower.z();
  }
}

/// Whether a function with such slopes along an axis takes its least value at an end.
bool rises_or_falls(const Interval& slope) { return slope.lower >= 0 || slope.upper <= 0; }

/// Greatest height of the solid in a box, if it is above `known`. `edges_empty`: whether the four upright edges of the
/// box contain nothing.
HiddenParts::Top highest_in(const Field& field, const Box& box, int depth, double known, bool edges_empty) {
  if (box.upper.z() <= known) return {nothing, true};
  const Restriction here = field.restricted(box, Purpose::occupancy);
  if (holds_nothing(here.range)) return {nothing, true};
  if (here.range.inside()) return {box.upper.z(), true};
  if (const PlaneBounds plane = plane_bounds(*here.field, box); plane.known) {
    if (plane.lower() > 0) return {nothing, true};
    // At each height the least value is at one of the edges.
    if (edges_empty && rises_or_falls(plane.slopes[0]) && rises_or_falls(plane.slopes[1])) return {nothing, true};
  }
  if (depth == 0) return {box.upper.z(), false};
  Eigen::Index axis = 0;
  box.size().maxCoeff(&axis);
  Box upper = box, lower = box;
  upper.lower[axis] = lower.upper[axis] = box.centre()[axis];
  edges_empty = edges_empty && axis == 2;
  const HiddenParts::Top first = highest_in(*here.field, upper, depth - 1, known, edges_empty);
  if (axis == 2 && first.z > nothing) return first;
  const HiddenParts::Top second = highest_in(*here.field, lower, depth - 1, std::max(known, first.z), edges_empty);
  return second.z > first.z ? second : first;
}

}  // namespace

Box HiddenParts::above(const HeightMap& heights, int left, int low, int right, int high, double z, double top) const {
  const Vec2 a = heights.place(left, low), b = heights.place(right, high);
  return intersection(bounds_, {{a.x(), a.y(), z}, {b.x(), b.y(), top}});
}

void HiddenParts::search(const Field& field, const HeightMap& heights, int left, int low, int right, int high,
                         const std::function<void(const SuspectSquare&)>& visit) const {
  search(field, heights, left, low, right, high, bounds_.upper.z(), visit);
}

void HiddenParts::search(const Field& field, const HeightMap& heights, int left, int low, int right, int high,
                         double top, const std::function<void(const SuspectSquare&)>& visit) const {
  if (left >= right || low >= high) return;
  const Samples samples{heights, left, low, right, high};
  const auto [least, most] = samples.range();
  Box box = above(heights, left, low, right, high, static_cast<double>(least) + slack_, top);
  if (!box.valid()) return;
  const Restriction here = field.restricted(box, Purpose::occupancy);
  if (holds_nothing(here.range)) return;
  lower_top(*here.field, box);
  const PlaneBounds plane = plane_bounds(*here.field, box);
  if (plane.known && samples.under_plane(plane, slack_)) return;
  if (right - left == 1 && high - low == 1) {
    const auto stands_out = [&] {
      const Box rest = above(heights, left, low, right, high, static_cast<double>(most) + coarse_slack_, box.upper.z());
      return rest.valid() && !holds_nothing(here.field->restricted(rest, Purpose::occupancy).range);
    };
    if (plane.known || stands_out()) visit({left, low, box.upper.z(), here.field, plane.known});
    return;
  }
  const int u = (left + right + 1) / 2, v = (low + high + 1) / 2;
  search(*here.field, heights, left, low, u, v, box.upper.z(), visit);
  search(*here.field, heights, u, low, right, v, box.upper.z(), visit);
  search(*here.field, heights, left, v, u, high, box.upper.z(), visit);
  search(*here.field, heights, u, v, right, high, box.upper.z(), visit);
}

HiddenParts::Top HiddenParts::highest(const HeightMap& heights, const SuspectSquare& square) const {
  constexpr int depth = 16;
  const int right = square.column + 1, high = square.row + 1;
  const double most = static_cast<double>(Samples{heights, square.column, square.row, right, high}.range().second);
  const Box box = above(heights, square.column, square.row, right, high, most + slack_, square.top);
  if (!box.valid()) return {nothing, true};
  const bool whole = box.lower.head<2>() == heights.place(square.column, square.row) &&
                     box.upper.head<2>() == heights.place(right, high);
  return highest_in(*square.field, box, depth, nothing, whole);
}

}  // namespace fieldfab::cam
