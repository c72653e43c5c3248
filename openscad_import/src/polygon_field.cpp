#include "polygon_field.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "polygon_distance.h"

namespace fieldfab::openscad {
namespace {

using Distance = std::shared_ptr<const PolygonDistance>;
constexpr double huge = 1e30;

/// Double precision loses less than this on the way to a value; floats are rounded from there.
double margin(double value) { return 1e-9 + 1e-12 * std::abs(value); }

struct Span {
  double lower, upper;
};

Interval rounded(const Span& span) { return {static_cast<float>(span.lower), static_cast<float>(span.upper), false}; }

/// Distances over the rectangle about `centre` with that half diagonal, and what is near of the outlines.
Span distances(const Distance& whole, const Vec2& centre, double reach, Distance& near) {
  double middle = 0;
  near = whole->near(centre, reach, middle);
  if (!near) near = whole;
  const double wide = reach + margin(std::abs(middle) + reach + centre.cwiseAbs().maxCoeff());
  return {middle - wide, middle + wide};
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
  void restrict_all(std::span<const Box> boxes, Purpose, std::span<Restriction> out) const override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Part part = restricted_to(boxes[i]);
      out[i].range = part.range;
      out[i].field = part.outlines == outlines_
                         ? shared_from_this()
                         : std::make_shared<Extruded>(part.outlines, middle_ - half_, middle_ + half_, growth_);
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 10 + (outlines_ ? outlines_->cost() : 0); }

 private:
  struct Part {
    Interval range;
    Distance outlines;
  };
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
    if (outlines_) d = distances(outlines_, box.centre().head<2>(), 0.5 * box.size().head<2>().norm(), near);
    const Span all{joined(d.lower, w.lower) - growth_, joined(d.upper, w.upper) - growth_};
    if (d.upper < w.lower && d.upper < 0) near = nullptr;  // the ends alone decide
    return {rounded(all), near};
  }

  Distance outlines_;  ///< null where they do not matter
  double middle_, half_, growth_;
};

class Turned final : public Field {
 public:
  Turned(Distance profile, const Turn& turn, double growth)
      : profile_(std::move(profile)), turn_(turn), growth_(growth), shrink_(turn.fragments > 0 ? std::cos(turn.step / 2) : 1) {}

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
      out[i] =
          at.allFinite() ? static_cast<float>(shrink_ * nearest.distance - growth_) : std::numeric_limits<float>::quiet_NaN();
      slopes.dx[i] = static_cast<float>(nearest.slope.x() * direction.x());
      slopes.dy[i] = static_cast<float>(nearest.slope.x() * direction.y());
      slopes.dz[i] = static_cast<float>(nearest.slope.y() * shrink_);
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return restricted_to(box).range; }
  void restrict_all(std::span<const Box> boxes, Purpose, std::span<Restriction> out) const override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Part part = restricted_to(boxes[i]);
      out[i].range = part.range;
      out[i].field = part.profile == profile_ ? shared_from_this() : std::make_shared<Turned>(part.profile, turn_, growth_);
    }
  }
  [[nodiscard]] std::size_t cost() const noexcept override { return 40 + profile_->cost(); }

 private:
  struct Part {
    Interval range;
    Distance profile;
  };
  /// Where a point lies in the profile, as far out as the corners of its side are; and the way out there.
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
  [[nodiscard]] Part restricted_to(const Box& box) const {
    if (!is_finite(box)) return {Interval::unknown(), profile_};
    const Vec2 centre = box.centre().head<2>();
    const Vec2 half = 0.5 * box.size().head<2>();
    const double out = out_from_axis(centre.x(), centre.y()).first;
    // The way out is the greatest of linear functions, none steeper than this.
    const double reach = half.norm() / shrink_ + margin(out);
    const Vec2 middle(out, box.centre().z());
    Distance near;
    const Span d = distances(profile_, middle, std::hypot(reach, 0.5 * box.size().z()), near);
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
