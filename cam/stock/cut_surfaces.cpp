#include "cut_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fieldfab::cam {
namespace {

/// A distance and its derivatives, in the plane of a half section: away from the axis, and along it.
struct Section {
  double distance = std::numeric_limits<double>::infinity(), out = 0, up = 0;
};

Section from_point(double r, double z, double size) {
  const double length = std::sqrt(r * r + z * z);  // hypot would be slower, and lengths are no extremes
  return length > 0 ? Section{length - size, r / length, z / length} : Section{-size, 0, -1};
}

Section from_frustum(double r, double z, const Zone& zone) {
  const double wide = zone.r1 - zone.r0, high = zone.z1 - zone.z0, slant = std::sqrt(wide * wide + high * high);
  const double out = high / slant, up = -wide / slant;
  const double side = (r - zone.r0) * out + (z - zone.z0) * up;
  const double below = zone.z0 - z, above = z - zone.z1;
  if (side <= 0 && below <= 0 && above <= 0) {
    if (side >= below && side >= above) return {side, out, up};
    return below >= above ? Section{below, 0, -1} : Section{above, 0, 1};
  }
  if (below >= 0 && r <= zone.r0) return {below, 0, -1};
  if (above >= 0 && r <= zone.r1) return {above, 0, 1};
  const double along = ((r - zone.r0) * wide + (z - zone.z0) * high) / slant;
  if (along <= 0) return from_point(r - zone.r0, z - zone.z0, 0);
  if (along >= slant) return from_point(r - zone.r1, z - zone.z1, 0);
  return {side, out, up};
}

Section from_zone(double r, double z, const Zone& zone) {
  if (zone.shape == Zone::Shape::frustum) return from_frustum(r, z, zone);
  if (zone.shape == Zone::Shape::ball) return from_point(r, z - zone.z0, zone.r0);
  return from_point(std::max(r - zone.r0, 0.0), z - zone.z0, zone.r1);
}

/// A point's distance from a piece in one pose, and the direction away from it.
struct Distance {
  double value = std::numeric_limits<double>::infinity();
  Vec3 away = Vec3::UnitZ();
};

/// The distance of a point from a piece that moves, as a function of time.
class Moving {
 public:
  Moving(const StrokeLog::Entry& stroke, const Vec3& place)
      : stroke_(stroke),
        place_(place),
        way_(stroke.to.tip - stroke.from.tip),
        turn_(stroke.to.axis - stroke.from.axis) {}

  [[nodiscard]] Distance at(double time) const {
    Vec3 axis = stroke_.from.axis;
    if (turns()) axis = (axis + time * turn_).normalized();
    const Vec3 from_tip = place_ - stroke_.from.tip - time * way_;
    const double z = from_tip.dot(axis);
    Vec3 out = from_tip - z * axis;
    const double r = out.norm();
    if (r > 1e-12)
      out /= r;
    else
      out = axis.unitOrthogonal();
    Section least;
    for (const Zone& zone : stroke_.piece.zones)
      if (const Section section = from_zone(r, z, zone); section.distance < least.distance) least = section;
    return {least.distance, least.out * out + least.up * axis};
  }

  [[nodiscard]] Distance least() const {
    if (turns()) return least_while_turning();
    if (way_.squaredNorm() < 1e-18) return at(0);
    const double way = way_.norm(), rise = way_.dot(stroke_.from.axis);
    // At one height of the tool: where its axis passes nearest.
    if (std::abs(rise) < 1e-9 * way)
      return at(std::clamp((place_ - stroke_.from.tip).dot(way_) / way_.squaredNorm(), 0.0, 1.0));
    // The distance is convex in time, because the piece is: its slope, -away . way, rises. Its zero by the Illinois
    // method.
    Distance low = at(0);
    double slope_low = -low.away.dot(way_);
    if (slope_low >= 0) return low;
    Distance high = at(1);
    double slope_high = -high.away.dot(way_), begin = 0, end = 1;
    if (slope_high <= 0) return high;
    int side = 0;
    for (int step = 0; step < 40 && end - begin > 1e-6; ++step) {
      const double middle = begin + slope_low / (slope_low - slope_high) * (end - begin);
      const Distance now = at(middle);
      const double slope = -now.away.dot(way_);
      if (std::abs(slope) < 1e-5 * way) return now;
      if (slope < 0) {
        begin = middle, slope_low = slope, low = now;
        if (side < 0) slope_high /= 2;
        side = -1;
      } else {
        end = middle, slope_high = slope, high = now;
        if (side > 0) slope_low /= 2;
        side = 1;
      }
    }
    return low.value < high.value ? low : high;
  }

 private:
  [[nodiscard]] bool turns() const { return turn_.squaredNorm() > 1e-14; }

  /// By sections of the interval around the least of some moments.
  [[nodiscard]] Distance least_while_turning() const {
    constexpr int moments = 8;
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= moments; ++i)
      if (const double value = at(static_cast<double>(i) / moments).value; value < least) least = value, best = i;
    double begin = std::max(best - 1.0, 0.0) / moments, end = std::min(best + 1.0, 1.0 * moments) / moments;
    constexpr double golden = 0.6180339887498949;
    double one = end - golden * (end - begin), other = begin + golden * (end - begin);
    double at_one = at(one).value, at_other = at(other).value;
    for (int step = 0; step < 36; ++step) {
      if (at_one <= at_other) {
        end = other, other = one, at_other = at_one;
        one = end - golden * (end - begin), at_one = at(one).value;
      } else {
        begin = one, one = other, at_one = at_other;
        other = begin + golden * (end - begin), at_other = at(other).value;
      }
    }
    return at(0.5 * (begin + end));
  }

  const StrokeLog::Entry& stroke_;
  Vec3 place_, way_, turn_;
};

/// A box around all that a stroke sweeps.
Box bounds_of(const StrokeLog::Entry& stroke) {
  const double low = stroke.low, high = stroke.high;
  Box box{stroke.from.tip + low * stroke.from.axis, stroke.from.tip + low * stroke.from.axis};
  for (const Vec3& end : {Vec3(stroke.from.tip + high * stroke.from.axis), Vec3(stroke.to.tip + low * stroke.to.axis),
                          Vec3(stroke.to.tip + high * stroke.to.axis)})
    box = hull(box, {end, end});
  return box.grown(1.000001 * static_cast<double>(stroke.radius));
}

bool near(const Box& box, const Vec3& place, double distance) {
  return ((place - box.upper).array() <= distance).all() && ((box.lower - place).array() <= distance).all();
}

/// The axis of the lattice along which a flat-ended tool stands; 3: another tool or direction.
std::uint8_t stands_along(const StrokeLog::Entry& stroke) {
  const Zone& end = stroke.piece.zones.front();
  if (end.shape != Zone::Shape::frustum || end.r0 <= 0) return 3;
  for (std::uint8_t d = 0; d < 3; ++d)
    if (std::abs(stroke.from.axis[d]) == 1 && std::abs(stroke.to.axis[d]) == 1) return d;
  return 3;
}

}  // namespace

CutSurfaces::CutSurfaces(const Stock& stock)
    : first_(stock.first_),
      origin_(stock.lattice().box().lower),
      log_(stock.strokes_),
      cell_(stock.lattice().spacing().minCoeff()) {
  if (!log_) return;
  strokes_ = log_->all();
  std::stable_sort(strokes_.begin(), strokes_.end(),
                   [](const auto& one, const auto& other) { return one.cut < other.cut; });
  for (std::uint32_t i = 0; i < strokes_.size(); ++i) {
    const StrokeLog::Entry stroke = StrokeLog::at(strokes_[i]);
    if (cuts_.empty() || cuts_.back().number != strokes_[i].cut)
      cuts_.push_back({strokes_[i].cut, i, i, false, stands_along(stroke)});
    const Box bounds = bounds_of(stroke);
    if (i % group == 0)
      groups_.push_back(bounds);
    else
      groups_.back() = hull(groups_.back(), bounds);
    Cut& cut = cuts_.back();
    cut.last = i + 1;
    for (const Zone& zone : stroke.piece.zones) cut.edges |= zone.lower_edge;
    if (cut.level != stands_along(stroke)) cut.level = 3;
  }
}

const CutSurfaces::Cut* CutSurfaces::find(std::uint32_t number) const {
  const auto found = std::lower_bound(cuts_.begin(), cuts_.end(), number,
                                      [](const Cut& cut, std::uint32_t wanted) { return cut.number < wanted; });
  return found != cuts_.end() && found->number == number ? &*found : nullptr;
}

bool CutSurfaces::has_edges(std::uint32_t cut) const {
  const Cut* const found = find(cut);
  return found && found->edges;
}

std::size_t CutSurfaces::level_axis(std::uint32_t cut) const {
  const Cut* const found = find(cut);
  return found ? found->level : 3;
}

std::optional<CutSurfaces::Nearest> CutSurfaces::nearest(const Cut& cut, const Vec3& place, double within) const {
  Nearest nearest{within, Vec3::Zero()};
  for (std::uint32_t i = cut.first; i < cut.last; ++i) {
    if (cut.last - cut.first > group && !near(groups_[i / group], place, nearest.distance)) {
      i += group - 1 - i % group;  // the next stroke is the first of the next group
      continue;
    }
    const StrokeLog::Entry stroke = StrokeLog::at(strokes_[i]);
    if (!near(bounds_of(stroke), place, nearest.distance)) continue;
    const Distance distance = Moving(stroke, place).least();
    if (distance.value < nearest.distance) nearest = {distance.value, distance.away};
  }
  if (nearest.distance == within) return {};
  return nearest;
}

std::optional<CutSurfaces::Plane> CutSurfaces::tangent_to_first(const Vec3& place) const {
  if (!first_) return {};
  const Eigen::Vector3f at = (place + origin_).cast<float>();
  float value = 0;
  Eigen::Vector3f slope;
  first_->gradients({&at.x(), &at.y(), &at.z(), 1}, &value, {&slope.x(), &slope.y(), &slope.z()});
  const double length = slope.cast<double>().norm(), distance = value / length;
  // Where the solid reaches the box, the surface is not the Field's.
  if (!(length > 0) || !std::isfinite(length) || !(std::abs(distance) < 0.1 * cell_)) return {};
  const Vec3 normal = slope.cast<double>() / length;
  return Plane{place - distance * normal, normal};
}

std::optional<CutSurfaces::Plane> CutSurfaces::tangent(std::uint32_t cut, const Vec3& place, const Vec3& inward) const {
  if (cut == 0) return tangent_to_first(place);
  const Cut* const found = find(cut);
  if (!found) return {};
  // On the surface itself the direction to the nearest point is not defined. A little outside of the swept volume it
  // is; farther out where the sample deviates from the exact surface, as those of turning tools may.
  for (double step = 0.01 * cell_; step < 0.2 * cell_; step *= 4) {
    const Vec3 outside = place + step * inward;
    const std::optional<Nearest> near = nearest(*found, outside, 2 * step + 0.1 * cell_);
    if (!near) return {};
    if (near->distance > 0.1 * step) return Plane{outside - near->distance * near->outward, -near->outward};
  }
  return {};
}

}  // namespace fieldfab::cam
