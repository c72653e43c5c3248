#include "fieldfab/field/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/plane_bounds.h"
#include "fieldfab/field/surface_proof.h"

namespace fieldfab {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Fraction of the cube [-1, 1]^3 with weights . u < limit, for weights of at least 0. With sorted
/// weights it is a sum over the corners below the plane (Scardovelli and Zaleski 2000).
double part_below(std::array<double, 3> weights, double limit) {
  const double all = weights[0] + weights[1] + weights[2];
  if (limit <= -all) return 0;
  if (limit >= all) return 1;
  std::sort(weights.begin(), weights.end());
  const double a = weights[0] / all, b = weights[1] / all, c = weights[2] / all;
  const double share = (limit + all) / (2 * all), d = std::min(share, 1 - share);
  const auto cube = [](double t) { return t > 0 ? t * t * t : 0; };
  double part = 0;
  if (a > 0)
    part = (cube(d) - cube(d - a) - cube(d - b) - cube(d - c) + cube(d - a - b)) / (6 * a * b * c);
  else if (b > 0)
    part = (d * d - (d > b ? (d - b) * (d - b) : 0)) / (2 * b * c);
  else
    part = d;
  return share <= 0.5 ? part : 1 - part;
}

/// Weights that are tiny compared with the largest would cancel in the formula; they count as an
/// error instead.
std::array<double, 3> weights_of(const PlaneBounds& plane, double& error) {
  constexpr double least = 1e-4;
  std::array<double, 3> weights;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    weights[axis] = std::abs(plane.slope[a]) * plane.half[a];
  }
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights)
    if (weight < least * largest) error += std::exchange(weight, 0);
  return weights;
}

Enclosed volume_in(const PlaneBounds& plane, double box_volume) {
  double error = plane.error;
  const auto weights = weights_of(plane, error);
  return {box_volume * part_below(weights, -plane.value - error),
          box_volume * part_below(weights, -plane.value + error)};
}

/// Area of the surface as a graph over the plane across `axis`, if the value is monotone along it;
/// infinite if the slopes do not prove that.
Enclosed area_over(const PlaneBounds& plane, int axis) {
  const auto extent = [&](int i) {
    const Interval& slope = plane.slopes[static_cast<std::size_t>(i)];
    const double low = std::abs(slope.lower), high = std::abs(slope.upper);
    const bool through_zero = slope.lower <= 0 && slope.upper >= 0;
    return Enclosed{through_zero ? 0 : std::min(low, high), std::max(low, high)};
  };
  // Surfaces that may be much steeper than the plane give useless bounds.
  constexpr double least_share = 0.02;
  const Enclosed along = extent(axis);
  if (!(along.lower > least_share * along.upper)) return {0, infinite};
  const int others[2] = {(axis + 1) % 3, (axis + 2) % 3};
  double error = 0, least = 1, most = 1;
  PlaneBounds across = plane;
  across.slope[axis] = 0;
  for (const int other : others) {
    const Enclosed steep = extent(other);
    least += steep.lower * steep.lower / (along.upper * along.upper);
    most += steep.upper * steep.upper / (along.lower * along.lower);
    const Interval& slope = plane.slopes[static_cast<std::size_t>(other)];
    error += 0.5 * (static_cast<double>(slope.upper) - static_cast<double>(slope.lower)) * plane.half[other];
  }
  // The surface passes between top and bottom if the magnitude of the value in the middle is at
  // most its change on the way.
  constexpr double rounding = 1e-6;
  error += rounding * (std::abs(plane.value) + along.upper * (std::abs(plane.centre[axis]) + plane.half[axis]));
  const auto weights = weights_of(across, error);
  const auto strip = [&](double width) {
    return width > 0 ? part_below(weights, -plane.value + width) - part_below(weights, -plane.value - width) : 0.0;
  };
  const double floor = 4 * plane.half[others[0]] * plane.half[others[1]];
  return {floor * strip(along.lower * plane.half[axis] - error) * std::sqrt(least),
          floor * strip(along.upper * plane.half[axis] + error) * std::sqrt(most)};
}

Enclosed area_in(const Field& field, const Box& box, const PlaneBounds& plane) {
  Enclosed area{0, infinite};
  for (int axis = 0; axis < 3; ++axis) {
    const Enclosed found = area_over(plane, axis);
    area = {std::max(area.lower, found.lower), std::min(area.upper, found.upper)};
  }
  if (std::isfinite(area.upper)) return area;
  // The area of a graph over a tilted plane is at most the area of the box's projection times the
  // secant of its greatest inclination.
  std::vector<Eigen::Vector3f> normals;
  for (const int halvings : {3, 0}) {  // the steepest first: without that proof there is none for less
    if (!prove_sheet(field, box, normals, box.size().maxCoeff(), halvings).one_sheet) break;
    const Vec3 size = box.size();
    const Vec3 faces(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
    area.upper = faces.norm() * std::hypot(1, std::ldexp(steepest_in_cells, halvings));
  }
  return area;
}

/// A box, and bounds for the solid in it.
struct Part {
  Box box;
  FieldPtr field;  ///< null if nothing remains to be refined
  Enclosed volume, area;
  Vec3 spread;  ///< contribution of each axis to the uncertainty of the Field's values, as far as it is known
};

Part part_of(const Box& box, const Restriction& here) {
  Part part{box, nullptr, {}, {}, box.size()};
  if (here.range.outside()) return part;
  const double all = box.size().prod();
  if (here.range.inside()) {
    part.volume = {all, all};
    return part;
  }
  part.field = here.field;
  part.volume = {0, all};
  part.area = {0, infinite};
  if (const PlaneBounds plane = plane_bounds(*here.field, box); plane.known) {
    part.volume = volume_in(plane, all);
    part.area = area_in(*here.field, box, plane);
    for (int axis = 0; axis < 3; ++axis) {
      const Interval& slope = plane.slopes[static_cast<std::size_t>(axis)];
      part.spread[axis] = (static_cast<double>(slope.upper) - static_cast<double>(slope.lower)) * plane.half[axis];
    }
    if (!(part.spread.maxCoeff() > 0)) part.spread = box.size();
  }
  return part;
}

/// Divides a box near its middle, along the axes that spread values most; a thin plate only across.
/// Not exactly in the middle: faces of solids are often there, and the side of a face that lies in
/// a plane of division cannot be decided.
std::vector<Part> children_of(const Part& part) {
  const Vec3 size = part.box.size();
  std::vector<Box> boxes{part.box};
  for (int axis = 0; axis < 3; ++axis) {
    if (part.spread[axis] <= 0.5 * part.spread.maxCoeff()) continue;
    constexpr double share = 0.4871;
    const double middle = part.box.lower[axis] + share * size[axis];
    for (std::size_t i = boxes.size(); i-- > 0;) {
      boxes.push_back(boxes[i]);
      boxes[i].upper[axis] = boxes.back().lower[axis] = middle;
    }
  }
  std::vector<Restriction> here(boxes.size());
  part.field->restrict_all(boxes, Purpose::value, here);
  std::vector<Part> children;
  for (std::size_t i = 0; i < boxes.size(); ++i) children.push_back(part_of(boxes[i], here[i]));
  return children;
}

void add(Measures& sum, const Part& part) {
  sum.volume.lower += part.volume.lower, sum.volume.upper += part.volume.upper;
  sum.area.lower += part.area.lower, sum.area.upper += part.area.upper;
}

/// Ratio of an error to the wanted one.
double excess(double error, const Enclosed& all, double accuracy) {
  const double size = std::max(all.lower, 1e-3 * (std::isfinite(all.upper) ? all.upper : all.lower));
  return error > 0 ? error / (accuracy * size) : 0;
}

/// Contribution of one part to the errors of the whole: to that of the volume first, and to that of
/// the area once the volume is accurate. A quantity that is accurate enough contributes 0.
double open_in(const Part& part, const Measures& whole, const MeasureSettings& settings) {
  double found = 0;
  if (excess(whole.volume.error(), whole.volume, settings.volume_accuracy) > 1) {
    found = excess(part.volume.error(), whole.volume, settings.volume_accuracy);
  } else if (excess(whole.area.error(), whole.area, settings.area_accuracy) > 1) {
    const bool known = std::isfinite(part.area.upper);
    const double error = known ? part.area.error() : 6 * std::pow(part.box.size().maxCoeff(), 2);
    found = excess(error, whole.area, settings.area_accuracy);
  }
  return std::isfinite(found) ? found : 1;
}

/// Threshold of the contribution above which parts are divided: half of the average, or more if few
/// boxes are left.
double least_divided(std::vector<double> left, std::size_t boxes_left) {
  const double average = std::accumulate(left.begin(), left.end(), 0.0) / static_cast<double>(left.size());
  const std::size_t most = boxes_left / 4 + 1;
  if (left.size() <= most) return 0.5 * average;
  const auto last = left.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(left.begin(), last, left.end(), std::greater<>());
  return std::max(0.5 * average, *last);
}

std::string text_of(const Enclosed& number, const char* unit) {
  if (!std::isfinite(number.upper)) return fmt::format("at least {:.4g} {}", number.lower, unit);
  // As many digits as the error permits.
  const double error = number.error(), size = std::max(std::abs(number.middle()), 1e-300);
  const int digits = error > 0 ? std::clamp(2 + static_cast<int>(std::floor(std::log10(size / error))), 2, 9) : 9;
  return fmt::format("{:.{}g} +- {:.2g} {}", number.middle(), digits, error, unit);
}

}  // namespace

std::string Measures::text() const {
  return fmt::format("volume {}, area {}", text_of(volume, "mm3"), text_of(area, "mm2"));
}

Measures measure(const Field& field, const Box& bounds, const MeasureSettings& settings, Progress& progress) {
  if (!bounds.valid()) throw Error(ErrorKind::bad_input, "bounds", "must be finite to measure a solid");
  std::vector<Part> open{part_of(bounds, field.restricted(bounds))};
  Measures closed, whole;
  for (std::size_t boxes = 1;;) {
    progress.check();
    progress.report(static_cast<double>(boxes) / static_cast<double>(settings.most_boxes), "measuring the solid");
    whole = closed;
    for (const Part& part : open) add(whole, part);
    whole.boxes = boxes;
    if (open.empty() || boxes >= settings.most_boxes) break;
    std::vector<double> left(open.size());
    for (std::size_t i = 0; i < open.size(); ++i) left[i] = open[i].field ? open_in(open[i], whole, settings) : 0;
    const double least = least_divided(left, settings.most_boxes - boxes);
    std::vector<std::vector<Part>> found(open.size());
    parallel_for(open.size(), [&](std::size_t i) {
      progress.check();
      if (left[i] > 0 && left[i] >= least) found[i] = children_of(open[i]);
    });
    std::vector<Part> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      boxes += found[i].size();
      if (found[i].empty()) found[i].push_back(std::move(open[i]));
      for (Part& part : found[i])
        if (part.field && (part.volume.error() > 0 || part.area.error() > 0))
          next.push_back(std::move(part));
        else
          add(closed, part);
    }
    if (boxes == whole.boxes) break;  // no part can be divided
    open = std::move(next);
  }
  // Margin for the rounding of long sums.
  constexpr double rounding = 1e-11;
  for (Enclosed* const number : {&whole.volume, &whole.area})
    number->lower *= 1 - rounding, number->upper *= 1 + rounding;
  return whole;
}

}  // namespace fieldfab
