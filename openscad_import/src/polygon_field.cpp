#include "polygon_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "few_directions.h"
#include "fieldfab/field/distance_slopes.h"
#include "polygon_distance.h"

namespace fieldfab::openscad {
namespace {

using Distance = std::shared_ptr<const PolygonDistance>;
constexpr double huge = 1e30;

/// Bound of rounding errors in double precision; values are rounded to floats afterwards.
double margin(double value) { return 1e-9 + 1e-12 * std::abs(value); }

struct Span {
  double lower, upper;
};

Interval rounded(const Span& span) { return {static_cast<float>(span.lower), static_cast<float>(span.upper), false}; }

/// Range of distances over the rectangle around `centre` with half diagonal `reach`, and the
/// outlines near it.
Span distances(const Distance& whole, const Vec2& centre, double reach, Distance& near) {
  double middle = 0;
  near = whole->near(centre, reach, middle);
  if (!near) near = whole;
  const double wide = reach + margin(std::abs(middle) + reach + centre.cwiseAbs().maxCoeff());
  return {middle - wide, middle + wide};
}

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper), a.maybe_nan || b.maybe_nan};
}

/// Minimum of cos(t) a + sin(t) b for t from `first` to `last`, which lie between 0 and a right
/// angle.
double least_mixture(double a, double b, double first, double last) {
  const double lowest = std::atan2(-b, -a);
  if (first < lowest && lowest < last) return -std::hypot(a, b);
  return std::min(std::cos(first) * a + std::sin(first) * b, std::cos(last) * a + std::sin(last) * b);
}

bool is_finite(const Box& box) { return box.lower.allFinite() && box.upper.allFinite(); }

class Extruded final : public Field {
 public:
  Extruded(Distance outlines, double lower, double upper, double growth)
      : outlines_(std::move(outlines)), middle_(0.5 * (lower + upper)), half_(0.5 * (upper - lower)), growth_(growth) {}

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const double across = outlines_ ? outlines_->at({points.x[i], points.y[i]}).distance : -huge;
      const double value = joined(across, along(points.z[i])) - growth_;
      out[i] = std::isnan(points.x[i]) || std::isnan(points.y[i]) || std::isnan(points.z[i])
                   ? std::numeric_limits<float>::quiet_NaN()
                   : static_cast<float>(value);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    values(points, out);
    for (std::size_t i = 0; i < points.count; ++i) {
      PolygonDistance::Nearest nearest{-huge, Vec2::Zero()};
      if (outlines_) nearest = outlines_->at({points.x[i], points.y[i]});
      const double w = along(points.z[i]), up = points.z[i] >= middle_ ? 1 : -1;
      double share_across = nearest.distance >= w ? 1 : 0, share_along = 1 - share_across;
      if (nearest.distance > 0 && w > 0) {
        const double length = std::hypot(nearest.distance, w);
        share_across = nearest.distance / length, share_along = w / length;
      }
      slopes.dx[i] = static_cast<float>(share_across * nearest.slope.x());
      slopes.dy[i] = static_cast<float>(share_across * nearest.slope.y());
      slopes.dz[i] = static_cast<float>(share_along * up);
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return restricted_to(box).range; }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    std::fill_n(out.begin(), directions.size(), Interval::unknown());
    if (!is_finite(box)) return;
    const Part part = restricted_to(box);
    const bool above = box.upper.z() >= middle_, below = box.lower.z() <= middle_;
    const auto along_z = [&](double up) -> Interval {
      const auto step = static_cast<float>(up);
      return {above && below ? -std::abs(step)
              : above        ? step
                             : -step,
              above && below ? std::abs(step)
              : above        ? step
                             : -step,
              false};
    };
    for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
      std::array<Vec2, lanes> flat;
      std::array<Interval, lanes> across;
      for (std::size_t i = 0; i < some.size(); ++i) flat[i] = some[i].head<2>();
      if (part.outlines)
        part.outlines->slopes(box.centre().head<2>(), half_diagonal(box), {flat.data(), some.size()}, across);
      for (std::size_t i = 0; i < some.size(); ++i)
        out[first + i] = joined_slope(part, across[i], along_z(some[i].z()), some[i].norm());
    });
  }
  void restrict_all(std::span<const Box> boxes, Purpose, std::span<Restriction> out) const override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Part part = restricted_to(boxes[i]);
      out[i].range = part.range;
      out[i].field = part.outlines == outlines_
                         ? RestrictedField(*this)
                         : std::make_shared<Extruded>(part.outlines, middle_ - half_, middle_ + half_, growth_);
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 10 + (outlines_ ? outlines_->cost() : 0); }

 private:
  struct Part {
    Interval range;
    Distance outlines;
    Span across{}, along{};  ///< distances to the outlines, if they matter, and to the ends
  };
  static double half_diagonal(const Box& box) { return 0.5 * box.size().head<2>().norm(); }

  /// Slope of joined(). Outside both, it is cos(t) times the slope across plus sin(t) times the
  /// slope along, with the angle t of the direction to the nearest edge; elsewhere the slope of the
  /// greater one.
  static Interval joined_slope(const Part& part, const Interval& across, const Interval& along, double steepest) {
    if (!part.outlines) return along;
    if (across.maybe_nan) return across;
    const Span &d = part.across, &w = part.along;
    if (d.upper <= 0 || w.upper <= 0)
      return d.lower >= w.upper ? across : w.lower > d.upper ? along : hull(across, along);
    const double right = 0.5 * std::numbers::pi;
    const double least = std::atan2(std::max(w.lower, 0.0), d.upper),
                 most = d.lower > 0 ? std::atan2(w.upper, d.lower) : right;
    const double lower = least_mixture(across.lower, along.lower, least, most);
    const double upper = -least_mixture(-across.upper, -along.upper, least, most);
    return rounded({std::max(lower, -steepest), std::min(upper, steepest)});
  }
  [[nodiscard]] double along(double z) const { return std::abs(z - middle_) - half_; }
  static double joined(double across, double along) {
    return across > 0 && along > 0 ? std::hypot(across, along) : std::max(across, along);
  }
  [[nodiscard]] Part restricted_to(const Box& box) const {
    if (!is_finite(box)) return {Interval::unknown(), outlines_};
    const double low = along(box.lower.z()), high = along(box.upper.z());
    const bool holds_middle = box.lower.z() <= middle_ && middle_ <= box.upper.z();
    const double slack = margin(std::abs(low) + std::abs(high));
    const Span w{(holds_middle ? -half_ : std::min(low, high)) - slack, std::max(low, high) + slack};
    Span d{-huge, -huge};
    Distance near = outlines_;
    if (outlines_) d = distances(outlines_, box.centre().head<2>(), half_diagonal(box), near);
    const Span all{joined(d.lower, w.lower) - growth_, joined(d.upper, w.upper) - growth_};
    if (d.upper < w.lower && d.upper < 0) near = nullptr;  // only the ends matter
    return {rounded(all), near, d, w};
  }

  Distance outlines_;  ///< null if the outlines do not matter
  double middle_, half_, growth_;
};

class Turned final : public Field {
 public:
  Turned(Distance profile, const Turn& turn, double growth)
      : profile_(std::move(profile)),
        turn_(turn),
        growth_(growth),
        shrink_(turn.fragments > 0 ? std::cos(turn.step / 2) : 1) {}

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const Vec2 at(out_from_axis(points.x[i], points.y[i]).first, points.z[i]);
      out[i] = at.allFinite() ? static_cast<float>(shrink_ * profile_->at(at).distance - growth_)
                              : std::numeric_limits<float>::quiet_NaN();
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const auto [distance, direction] = out_from_axis(points.x[i], points.y[i]);
      const Vec2 at(distance, points.z[i]);
      const PolygonDistance::Nearest nearest = profile_->at(at);
      out[i] = at.allFinite() ? static_cast<float>(shrink_ * nearest.distance - growth_)
                              : std::numeric_limits<float>::quiet_NaN();
      slopes.dx[i] = static_cast<float>(nearest.slope.x() * direction.x());
      slopes.dy[i] = static_cast<float>(nearest.slope.x() * direction.y());
      slopes.dz[i] = static_cast<float>(nearest.slope.y() * shrink_);
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return restricted_to(box).range; }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    std::fill_n(out.begin(), directions.size(), Interval::unknown());
    if (!is_finite(box)) return;
    const auto [middle, reach] = in_profile(box);
    const std::vector<Vec2> ways = ways_out(box);
    for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
      // A step moves radially by an amount within the bounds of the directions there, and along z
      // by its own component.
      std::array<Vec2, 2 * lanes> steps;
      for (std::size_t i = 0; i < some.size(); ++i) {
        const Span out_by = steps_out(ways, some[i].head<2>());
        steps[2 * i] = {out_by.lower, some[i].z()};
        steps[2 * i + 1] = {out_by.upper, some[i].z()};
      }
      std::array<Interval, 2 * lanes> changes;
      profile_->slopes(middle, reach, {steps.data(), 2 * some.size()}, changes);
      for (std::size_t i = 0; i < some.size(); ++i) {
        const Interval change = hull(changes[2 * i], changes[2 * i + 1]);
        if (!change.maybe_nan) out[first + i] = rounded({shrink_ * change.lower, shrink_ * change.upper});
      }
    });
  }
  void restrict_all(std::span<const Box> boxes, Purpose, std::span<Restriction> out) const override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Part part = restricted_to(boxes[i]);
      out[i].range = part.range;
      out[i].field =
          part.profile == profile_ ? RestrictedField(*this) : std::make_shared<Turned>(part.profile, turn_, growth_);
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 40 + profile_->cost(); }

 private:
  struct Part {
    Interval range;
    Distance profile;
  };
  /// Position of a point in the profile, at the radius of the corners of its side; and the radial
  /// direction there.
  [[nodiscard]] std::pair<double, Vec2> out_from_axis(double x, double y) const {
    if (turn_.fragments == 0) {
      const double r = std::hypot(x, y);
      return {r, r > 0 ? Vec2(x / r, y / r) : Vec2(1, 0)};
    }
    constexpr double full = 2 * std::numbers::pi;
    const double middle = turn_.first + 0.5 * turn_.fragments * turn_.step;
    double angle = std::atan2(y, x) - middle;  // from the middle of the turn
    angle -= full * std::round(angle / full);
    const double sides = std::abs(turn_.step);
    const double side = std::clamp(std::floor(angle / sides + 0.5 * turn_.fragments), 0.0, turn_.fragments - 1.0);
    const double way = middle + (side + 0.5 - 0.5 * turn_.fragments) * sides;
    const Vec2 direction(std::cos(way), std::sin(way));
    return {(x * direction.x() + y * direction.y()) / shrink_, direction};
  }
  /// Centre of a circle in the profile that contains the box, and its radius.
  [[nodiscard]] std::pair<Vec2, double> in_profile(const Box& box) const {
    const Vec2 centre = box.centre().head<2>();
    const Vec2 half = 0.5 * box.size().head<2>();
    const double out = out_from_axis(centre.x(), centre.y()).first;
    // The radial coordinate is a maximum of linear functions, none steeper than this.
    const double reach = half.norm() / shrink_ + margin(out);
    return {Vec2(out, box.centre().z()), std::hypot(reach, 0.5 * box.size().z())};
  }
  /// Returns the radial directions over a box: the two outermost for a round solid, those of all
  /// sides in the box otherwise; empty if any may occur.
  [[nodiscard]] std::vector<Vec2> ways_out(const Box& box) const {
    std::array<Vec2, 4> corners;
    for (unsigned i = 0; i < 4; ++i)
      corners[i] = {(i & 1U) != 0 ? box.upper.x() : box.lower.x(), (i & 2U) != 0 ? box.upper.y() : box.lower.y()};
    std::vector<Vec2> ways;
    if (turn_.fragments == 0) {
      if ((box.lower.head<2>().array() <= 0).all() && (box.upper.head<2>().array() >= 0).all()) return ways;
      const auto before = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x() > 0; };
      const auto [first, last] = std::minmax_element(corners.begin(), corners.end(), before);
      return {first->normalized(), last->normalized()};
    }
    // The radial coordinate is a maximum of linear functions; a function whose maximum in the box
    // is below another's minimum does not count.
    std::vector<double> most;
    double least = -std::numeric_limits<double>::infinity();
    for (int side = 0; side < turn_.fragments; ++side) {
      const double way = turn_.first + (side + 0.5) * turn_.step;
      ways.emplace_back(std::cos(way), std::sin(way));
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vec2& corner : corners) {
        const double out = ways.back().dot(corner);
        low = std::min(low, out), high = std::max(high, out);
      }
      most.push_back(high);
      least = std::max(least, low);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (most[i] >= least - margin(least)) ways[kept++] = ways[i];
    ways.resize(kept);
    return ways;
  }
  /// Bounds of the radial component of a step.
  [[nodiscard]] Span steps_out(const std::vector<Vec2>& ways, const Vec2& step) const {
    const double longest = step.norm();
    if (ways.empty()) return {-longest / shrink_, longest / shrink_};
    if (turn_.fragments == 0) {
      const std::array<Vec3, 2> ends{Vec3(ways[0].x(), ways[0].y(), 0), Vec3(ways[1].x(), ways[1].y(), 0)};
      const Interval found = NormalCone(ends).along({step.x(), step.y(), 0});
      return {found.lower, found.upper};
    }
    Span out{longest, -longest};
    for (const Vec2& way : ways) out = {std::min(out.lower, way.dot(step)), std::max(out.upper, way.dot(step))};
    return {out.lower / shrink_, out.upper / shrink_};
  }
  [[nodiscard]] Part restricted_to(const Box& box) const {
    if (!is_finite(box)) return {Interval::unknown(), profile_};
    const auto [middle, reach] = in_profile(box);
    Distance near;
    const Span d = distances(profile_, middle, reach, near);
    return {rounded({shrink_ * d.lower - growth_, shrink_ * d.upper - growth_}), near};
  }

  Distance profile_;
  Turn turn_;
  double growth_, shrink_;
};

}  // namespace

FieldPtr extruded_field(const Region& region, double lower, double upper, double growth) {
  return std::make_shared<Extruded>(std::make_shared<PolygonDistance>(region), lower, upper, growth);
}

FieldPtr flat_field(const Region& region, double growth) { return extruded_field(region, -huge, huge, growth); }

FieldPtr turned_field(const Region& symmetric_profile, const Turn& turn, double growth) {
  return std::make_shared<Turned>(std::make_shared<PolygonDistance>(symmetric_profile), turn, growth);
}

}  // namespace fieldfab::openscad
