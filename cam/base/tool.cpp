#include "fieldfab/cam/base/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/names.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

constexpr std::array<std::string_view, 8> shape_names{"flat",    "ball",  "bull",    "v",
                                                      "tapered", "drill", "profile", "form"};

}  // namespace

Profile::Profile(double flat, double corner, double taper, double radius)
    : flat_(flat), corner_(corner), taper_(taper), radius_(radius) {
  if (!(radius > 0) || !(flat >= 0) || !(corner >= 0) || !(taper >= 0) || !(taper < std::numbers::pi / 2) ||
      flat > radius * (1 + 1e-9))
    throw Error(ErrorKind::bad_input, "tool", "no cutter has this shape");
  bend_ = std::min(radius_, flat_ + corner_ * std::cos(taper_));
  bend_height_ = corner_ * (1 - std::sin(taper_));
  if (corner_ == 0 && flat_ < radius_) edges_.push_back(flat_);
  edges_.push_back(radius_);
}

Profile::Profile(std::vector<Vec2> points) : points_(std::move(points)) {
  if (points_.size() < 2 || points_.front().x() != 0 || !(points_.back().x() > 0))
    throw Error(ErrorKind::bad_input, "tool",
                "a profile begins on the axis and goes outwards: [[0, 0], ..., [radius, height]]");
  double lowest = points_[0].y();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].allFinite() || (i > 0 && points_[i].x() < points_[i - 1].x()))
      throw Error(ErrorKind::bad_input, "tool", "the points of a profile go outwards from the axis");
    lowest = std::min(lowest, points_[i].y());
    edges_.push_back(points_[i].x());
  }
  for (Vec2& p : points_) p.y() -= lowest;
  radius_ = points_.back().x();
}

double Profile::height(double distance) const {
  if (!points_.empty()) {
    // From the outside inwards: of two points at equal distance the lower one counts.
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec2 &a = points_[i], &b = points_[i + 1];
      if (distance < a.x() || distance > b.x()) continue;
      const double t = b.x() > a.x() ? (distance - a.x()) / (b.x() - a.x()) : 0;
      lowest = std::min({lowest, a.y() + t * (b.y() - a.y()), b.x() > a.x() ? lowest : b.y()});
    }
    return std::isfinite(lowest) ? lowest : points_.back().y();
  }
  if (distance <= flat_) return 0;
  if (distance >= bend_ && taper_ > 0) return bend_height_ + (distance - bend_) / std::tan(taper_);
  const double out = std::min(distance - flat_, corner_);
  return corner_ - std::sqrt(std::max(0.0, corner_ * corner_ - out * out));
}

double Profile::distance(double height) const {
  if (height < 0) return 0;
  if (!points_.empty()) {
    double widest = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec2 &a = points_[i], &b = points_[i + 1];
      const double low = std::min(a.y(), b.y());
      if (height < low) continue;
      const double t = a.y() == b.y() ? 1 : std::clamp((height - a.y()) / (b.y() - a.y()), 0.0, 1.0);
      widest = std::max(widest, a.x() + (height >= std::max(a.y(), b.y()) ? 1.0 : t) * (b.x() - a.x()));
    }
    return widest;
  }
  if (height >= bend_height_)
    return taper_ > 0 ? std::min(radius_, bend_ + (height - bend_height_) * std::tan(taper_)) : radius_;
  const double below = corner_ - height;
  return std::min(radius_, flat_ + std::sqrt(std::max(0.0, corner_ * corner_ - below * below)));
}

FlatCornerCone Profile::closed_form() const {
  const double slope = taper_ > 0 ? 1 / std::tan(taper_) : 0;
  const auto number = [](double d) { return static_cast<float>(d); };
  return {number(flat_),         number(corner_),
          number(bend_ - flat_), taper_ > 0 ? number(bend_height_ - bend_ * slope) : -1e30F,
          number(slope),         points_.empty()};
}

Profile Profile::grown(double by) const {
  if (by == 0) return *this;
  if (points_.empty()) {
    // The cone is offset along its normal, the cylinder outwards.
    return {flat_, corner_ + by, taper_, radius_ + by * (taper_ > 0 ? std::cos(taper_) : 1)};
  }
  // Lower envelope of discs of radius `by` about the profile, point by point.
  constexpr int steps = 256;
  std::vector<Vec2> outer;
  for (int i = 0; i <= steps; ++i) {
    const double at = (radius_ + by) * i / steps;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = -steps; k <= steps; ++k) {
      const double from = at + by * k / steps, out = by * k / steps;
      if (std::abs(from) <= radius_)
        lowest = std::min(lowest, height(std::abs(from)) - std::sqrt(std::max(0.0, by * by - out * out)));
    }
    outer.emplace_back(at, lowest + by);
  }
  return Profile(std::move(outer));
}

std::string_view name_of(ToolShape shape) { return shape_names[static_cast<std::size_t>(shape)]; }

ToolShape tool_shape_named(std::string_view name, const std::string& place) {
  return named<ToolShape>(name, shape_names, "shape", place);
}

Profile Tool::profile() const {
  const auto refuse = [&](const std::string& what) {
    return Error(ErrorKind::bad_input, fmt::format("tool {}", number), what);
  };
  if (shape != ToolShape::profile && !(diameter > 0)) throw refuse("needs a diameter above 0");
  const auto half_angle = [&] {
    if (!(angle > 0) || !(angle < std::numbers::pi))
      throw refuse(fmt::format("a {} tool needs an angle between 0 and 180 degrees", name_of(shape)));
    return angle / 2;
  };
  const auto check_corner = [&](const char* tool) {
    if (!(corner_radius > 0) || corner_radius > radius())
      throw refuse(fmt::format("a {} needs a corner_radius of at most its radius", tool));
  };
  switch (shape) {
    case ToolShape::profile: return Profile(points);
    case ToolShape::flat: return {radius(), 0, 0, radius()};
    case ToolShape::ball: return {0, radius(), 0, radius()};
    case ToolShape::bull: check_corner("bull-nose tool"); return {radius() - corner_radius, corner_radius, 0, radius()};
    case ToolShape::v:
    case ToolShape::drill:
      if (tip_diameter < 0 || tip_diameter >= diameter) throw refuse("tip_diameter must be less than the diameter");
      return {tip_diameter / 2, 0, half_angle(), radius()};
    case ToolShape::tapered: check_corner("tapered ball"); return {0, corner_radius, half_angle(), radius()};
    case ToolShape::form: break;
  }
  throw refuse("a form tool is for simulation only: nothing is planned with it");
}

}  // namespace fieldfab::cam
