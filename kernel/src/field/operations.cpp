// Operations on values: set operations, offset, shell, blend, morph. Operations that move points
// are in maps.cpp.
#include "fieldfab/field/operations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "chunk.h"
#include "fieldfab/core/error.h"
#include "forwarding.h"
#include "interval_sums.h"

namespace fieldfab {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

float least(float a, float b) { return a != a || b != b ? nan : (a <= b ? a : b); }
float greatest(float a, float b) { return a != a || b != b ? nan : (a >= b ? a : b); }
Interval least(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper), a.maybe_nan || b.maybe_nan};
}
Interval greatest(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper), a.maybe_nan || b.maybe_nan};
}
Interval times(const Interval& a, float factor) {
  const float l = a.lower * factor, u = a.upper * factor;
  if (l != l || u != u) return Interval::unknown();
  return {std::min(l, u), std::max(l, u), a.maybe_nan || ((std::isinf(a.lower) || std::isinf(a.upper)) && factor == 0)};
}
Interval root_of_magnitude(const Interval& a) {
  const float l = std::sqrt(std::abs(a.lower)), u = std::sqrt(std::abs(a.upper));
  return {a.lower <= 0 && a.upper >= 0 ? 0 : std::min(l, u), std::max(l, u), a.maybe_nan};
}

/// Slopes of sqrt|a| for values of a in `range` with slopes in `slope`.
Interval slope_of_root(const Interval& range, const Interval& slope) {
  if (range.maybe_nan || (range.lower <= 0 && range.upper >= 0)) return Interval::unknown();
  const float l = 0.5F / std::sqrt(std::abs(range.lower)), u = 0.5F / std::sqrt(std::abs(range.upper));
  const float sign = range.lower > 0 ? 1.0F : -1.0F;
  return times(slope, Interval{std::min(sign * l, sign * u), std::max(sign * l, sign * u), false});
}

/// Weights of the arguments' slopes in that of the result.
struct Weights {
  float a, b;
};

/// The argument that decides the value everywhere in a box.
enum class Only { both, first, second };

struct Union {
  float value(float a, float b) const { return least(a, b); }
  Weights weights(float a, float b) const { return a <= b ? Weights{1, 0} : Weights{0, 1}; }
  Interval range(const Interval& a, const Interval& b) const { return least(a, b); }
  // The first argument wins ties, for value and gradient. So it decides if the intervals touch, the
  // second only if they do not.
  Only decides(const Interval& a, const Interval& b) const {
    return a.upper <= b.lower ? Only::first : b.upper < a.lower ? Only::second : Only::both;
  }
  /// The slope of a minimum or maximum lies between the least and the greatest slope of its
  /// arguments.
  static Interval slope(const Interval&, const Interval&, const Interval& da, const Interval& db) {
    return hull(da, db);
  }
  static constexpr bool signs_are_enough = true, joins_smoothly = false;
  Only decides_sign(const Interval& a, const Interval& b) const {
    return b.outside() ? Only::first : a.outside() ? Only::second : Only::both;
  }
};

struct Intersection {
  float value(float a, float b) const { return greatest(a, b); }
  Weights weights(float a, float b) const { return a >= b ? Weights{1, 0} : Weights{0, 1}; }
  Interval range(const Interval& a, const Interval& b) const { return greatest(a, b); }
  Only decides(const Interval& a, const Interval& b) const {
    return a.lower >= b.upper ? Only::first : b.lower > a.upper ? Only::second : Only::both;
  }
  /// The slope of a minimum or maximum lies between the least and the greatest slope of its
  /// arguments.
  static Interval slope(const Interval&, const Interval&, const Interval& da, const Interval& db) {
    return hull(da, db);
  }
  static constexpr bool signs_are_enough = true, joins_smoothly = false;
  Only decides_sign(const Interval& a, const Interval& b) const {
    return b.inside() ? Only::first : a.inside() ? Only::second : Only::both;
  }
};

struct Blend {
  float root;  // square root of the radius
  float value(float a, float b) const {
    return least(least(a, b), std::sqrt(std::abs(a)) + std::sqrt(std::abs(b)) - root);
  }
  Weights weights(float a, float b) const {
    const float ra = std::sqrt(std::abs(a)), rb = std::sqrt(std::abs(b));
    if (least(a, b) <= ra + rb - root) return Union{}.weights(a, b);
    return {ra > 0 ? std::copysign(0.5F / ra, a) : 0, rb > 0 ? std::copysign(0.5F / rb, b) : 0};
  }
  Interval range(const Interval& a, const Interval& b) const { return least(least(a, b), fillet(a, b)); }
  [[nodiscard]] Interval slope(const Interval& a, const Interval& b, const Interval& da, const Interval& db) const {
    const Interval plain = hull(da, db);
    if (fillet(a, b).lower >= least(a, b).upper) return plain;
    return hull(plain, plus(slope_of_root(a, da), slope_of_root(b, db)));
  }
  static constexpr bool signs_are_enough = false, joins_smoothly = true;
  // Away from the fillet a blend is a union.
  Only decides(const Interval& a, const Interval& b) const {
    return fillet(a, b).lower >= least(a, b).upper ? Union{}.decides(a, b) : Only::both;
  }
  Only decides_sign(const Interval&, const Interval&) const { return Only::both; }

 private:
  [[nodiscard]] Interval fillet(const Interval& a, const Interval& b) const {
    return plus(plus(root_of_magnitude(a), root_of_magnitude(b)), Interval::of(-root));
  }
};

struct Morph {
  float first, second;  // weights that sum to 1
  float value(float a, float b) const { return first * a + second * b; }
  Weights weights(float, float) const { return {first, second}; }
  Interval range(const Interval& a, const Interval& b) const { return plus(times(a, first), times(b, second)); }
  [[nodiscard]] Interval slope(const Interval&, const Interval&, const Interval& da, const Interval& db) const {
    return range(da, db);
  }
  static constexpr bool signs_are_enough = false, joins_smoothly = true;
  Only decides(const Interval&, const Interval&) const { return Only::both; }
  Only decides_sign(const Interval&, const Interval&) const { return Only::both; }
};

/// A Field whose value is a function of the values of two others.
template <class Rule>
class Combined final : public Field {
 public:
  Combined(FieldPtr a, FieldPtr b, Rule rule) : a_(std::move(a)), b_(std::move(b)), rule_(rule) {}

  void values(const Points& points, float* out) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk other;
      a_->values(part, out + first);
      b_->values(part, other.data());
      for (std::size_t i = 0; i < part.count; ++i) out[first + i] = rule_.value(out[first + i], other[i]);
    });
  }

  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk other, dx, dy, dz;
      const Gradients mine{slopes.dx + first, slopes.dy + first, slopes.dz + first};
      a_->gradients(part, out + first, mine);
      b_->gradients(part, other.data(), {dx.data(), dy.data(), dz.data()});
      for (std::size_t i = 0; i < part.count; ++i) {
        const float a = out[first + i], b = other[i];
        const Weights w = rule_.weights(a, b);
        const auto mixed = [&](float one, float two) {
          return (w.a == 0 ? 0 : w.a * one) + (w.b == 0 ? 0 : w.b * two);
        };
        mine.dx[i] = mixed(mine.dx[i], dx[i]);
        mine.dy[i] = mixed(mine.dy[i], dy[i]);
        mine.dz[i] = mixed(mine.dz[i], dz[i]);
        out[first + i] = rule_.value(a, b);
      }
    });
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    return rule_.range(a_->interval(box), b_->interval(box));
  }

  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    const Interval a = a_->interval(box), b = b_->interval(box);
    Only only = Only::both;
    if (!a.maybe_nan && !b.maybe_nan) only = rule_.decides(a, b);
    if (only != Only::both) return (only == Only::first ? a_ : b_)->slopes(box, directions, out);
    for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
      std::array<Interval, slope_lanes> other;
      a_->slopes(box, some, out.subspan(first));
      b_->slopes(box, some, other);
      for (std::size_t i = 0; i < some.size(); ++i) out[first + i] = rule_.slope(a, b, out[first + i], other[i]);
    });
  }

  // The surface of a union or an intersection consists of those of its arguments.
  [[nodiscard]] bool faceted() const noexcept override {
    return Rule::signs_are_enough && (a_->faceted() || b_->faceted());
  }
  bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept override {
    if (!Rule::signs_are_enough) return Field::facing(box, directions);
    const Interval a = a_->interval(box), b = b_->interval(box);
    Only only = Only::both;
    if (!a.maybe_nan && !b.maybe_nan) only = rule_.decides(a, b);
    return (only == Only::second || a_->facing(box, directions)) &&
           (only == Only::first || b_->facing(box, directions));
  }

  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    // The signs of the arguments do not determine the sign of a blend or a morph, so values are
    // needed.
    const Purpose inner = Rule::signs_are_enough ? purpose : Purpose::value;
    std::vector<Restriction> other(boxes.size());
    a_->restrict_all(boxes, inner, out);
    b_->restrict_all(boxes, inner, other);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      out[i] = joined(std::move(out[i]), std::move(other[i]), inner == Purpose::occupancy);
  }

  /// The lattice of a scan among other solids; a restriction near its surface contains the scan
  /// alone.
  [[nodiscard]] std::optional<Sampling> sampling() const noexcept override {
    const std::optional<Sampling> a = a_->sampling(), b = b_->sampling();
    return !b ? a : !a ? b : std::nullopt;
  }
  [[nodiscard]] unsigned unread_axes() const noexcept override { return a_->unread_axes() & b_->unread_axes(); }
  [[nodiscard]] bool smooth() const noexcept override { return Rule::joins_smoothly && (a_->smooth() || b_->smooth()); }
  [[nodiscard]] std::size_t cost() const noexcept override { return a_->cost() + b_->cost() + 1; }

 private:
  [[nodiscard]] Restriction joined(Restriction a, Restriction b, bool by_sign) const {
    const Interval range = rule_.range(a.range, b.range);
    Only only = Only::both;
    if (!a.range.maybe_nan && !b.range.maybe_nan) only = rule_.decides(a.range, b.range);
    if (by_sign && only == Only::both) only = rule_.decides_sign(a.range, b.range);
    if (only != Only::both) return {range, only == Only::first ? a.field : b.field};
    if (a.field == a_ && b.field == b_) return {range, *this};
    return {range, std::make_shared<Combined>(std::move(a.field), std::move(b.field), rule_)};
  }

  FieldPtr a_, b_;
  Rule rule_;
};

/// factor * a + shift: complement, offset, and scaled distances.
class Linear final : public Field {
 public:
  Linear(FieldPtr a, float factor, float shift) : a_(std::move(a)), factor_(factor), shift_(shift) {}

  void values(const Points& points, float* out) const noexcept override {
    a_->values(points, out);
    for (std::size_t i = 0; i < points.count; ++i) out[i] = factor_ * out[i] + shift_;
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    a_->gradients(points, out, slopes);
    for (std::size_t i = 0; i < points.count; ++i) {
      out[i] = factor_ * out[i] + shift_;
      slopes.dx[i] *= factor_;
      slopes.dy[i] *= factor_;
      slopes.dz[i] *= factor_;
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return moved(a_->interval(box)); }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    a_->slopes(box, directions, out);
    for (Interval& slope : out.first(directions.size())) slope = times(slope, factor_);
  }
  [[nodiscard]] bool faceted() const noexcept override { return shift_ == 0 && a_->faceted(); }
  bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept override {
    if (shift_ != 0) return Field::facing(box, directions);
    const std::size_t first = directions.size();
    const bool known = a_->facing(box, directions);
    if (factor_ < 0)
      for (std::size_t i = first; i < directions.size(); ++i) directions[i] = -directions[i];
    return known;
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    a_->restrict_all(boxes, shift_ == 0 ? purpose : Purpose::value, out);
    for (Restriction& here : out.first(boxes.size())) {
      here.range = moved(here.range);
      if (here.field == a_)
        here.field = *this;
      else
        here.field = std::make_shared<Linear>(std::move(here.field), factor_, shift_);
    }
  }
  [[nodiscard]] Box known_bounds() const noexcept override {
    return factor_ > 0 && shift_ >= 0 ? a_->known_bounds() : Box::everything();
  }
  using Field::framed;
  [[nodiscard]] Framed framed(Purpose purpose) const override {
    if (purpose == Purpose::occupancy && shift_ == 0 && factor_ > 0) return a_->framed(purpose);
    Framed inner = a_->framed(purpose);
    if (inner.field == a_) return Field::framed(purpose);
    return {std::make_shared<Linear>(std::move(inner.field), factor_, shift_), inner.axes, inner.origin};
  }
  [[nodiscard]] bool sampled() const noexcept override { return a_->sampled(); }
  // An offset moves the ends of a scan off its samples.
  [[nodiscard]] std::optional<Sampling> sampling() const noexcept override {
    return shift_ == 0 ? a_->sampling() : std::nullopt;
  }
  [[nodiscard]] bool corners_tell(const Box& box) const noexcept override {
    return shift_ == 0 && a_->corners_tell(box);
  }
  [[nodiscard]] unsigned unread_axes() const noexcept override { return a_->unread_axes(); }
  [[nodiscard]] bool smooth() const noexcept override { return a_->smooth(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return a_->cost() + 1; }

 private:
  // factor is not 0 and shift is finite, so infinite ends stay infinite without NaN.
  [[nodiscard]] Interval moved(const Interval& a) const {
    const float l = factor_ * a.lower + shift_, u = factor_ * a.upper + shift_;
    return {std::min(l, u), std::max(l, u), a.maybe_nan};
  }

  FieldPtr a_;
  float factor_, shift_;
};

template <class Rule>
FieldPtr combined(FieldPtr a, FieldPtr b, Rule rule) {
  return std::make_shared<Combined<Rule>>(std::move(a), std::move(b), rule);
}

float finite(double value, const char* what) {
  const auto number = static_cast<float>(value);
  if (!std::isfinite(number)) throw Error(ErrorKind::bad_input, what, "must be a finite number");
  return number;
}

/// Signed position in a box: the maximum of the six face distances.
class BoxField final : public Field {
 public:
  explicit BoxField(const Box& box) : box_(box), lower_(box.lower.cast<float>()), upper_(box.upper.cast<float>()) {}

  void values(const Points& points, float* out) const noexcept override {
    for (std::size_t i = 0; i < points.count; ++i) {
      const float x = greatest(lower_.x() - points.x[i], points.x[i] - upper_.x());
      const float y = greatest(lower_.y() - points.y[i], points.y[i] - upper_.y());
      const float z = greatest(lower_.z() - points.z[i], points.z[i] - upper_.z());
      out[i] = greatest(greatest(x, y), z);
    }
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    values(points, out);
    for (std::size_t i = 0; i < points.count; ++i) {
      const std::array<float, 3> p{points.x[i], points.y[i], points.z[i]};
      std::array<float, 3> slope{};
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (out[i] == lower_[axis] - p[a])
          slope[a] = -1;
        else if (out[i] == p[a] - upper_[axis])
          slope[a] = 1;
        else
          continue;
        break;
      }
      slopes.dx[i] = slope[0], slopes.dy[i] = slope[1], slopes.dz[i] = slope[2];
    }
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    Interval range = Interval::of(-std::numeric_limits<float>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
      const auto l = static_cast<float>(box.lower[axis]), u = static_cast<float>(box.upper[axis]);
      range = greatest(range, greatest(Interval{lower_[axis] - u, lower_[axis] - l, false},
                                       Interval{l - upper_[axis], u - upper_[axis], false}));
    }
    return range;
  }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    // Hull of the slopes of the faces that can have the maximum somewhere in the box.
    const Interval all = interval(box);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      out[i] = {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), false};
      for (int axis = 0; axis < 3; ++axis) {
        const auto along = static_cast<float>(directions[i][axis]);
        if (lower_[axis] - static_cast<float>(box.lower[axis]) >= all.lower)
          out[i] = hull(out[i], Interval::of(-along));
        if (static_cast<float>(box.upper[axis]) - upper_[axis] >= all.lower) out[i] = hull(out[i], Interval::of(along));
      }
    }
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return box_; }
  [[nodiscard]] std::size_t cost() const noexcept override { return 11; }

 private:
  Box box_;
  Eigen::Vector3f lower_, upper_;
};

class Bounded final : public Forwarding {
 public:
  Bounded(FieldPtr field, const Box& bounds) : Forwarding(std::move(field)), bounds_(bounds) {}
  [[nodiscard]] Box known_bounds() const noexcept override { return bounds_; }

 private:
  Box bounds_;
};

}  // namespace

FieldPtr unite(FieldPtr a, FieldPtr b) { return combined(std::move(a), std::move(b), Union{}); }
FieldPtr intersect(FieldPtr a, FieldPtr b) { return combined(std::move(a), std::move(b), Intersection{}); }
FieldPtr subtract(FieldPtr a, FieldPtr b) { return intersect(std::move(a), complement(std::move(b))); }
FieldPtr complement(FieldPtr a) { return std::make_shared<Linear>(std::move(a), -1.0F, 0.0F); }
FieldPtr offset(FieldPtr a, double distance) {
  return std::make_shared<Linear>(std::move(a), 1.0F, -finite(distance, "offset"));
}

FieldPtr shell(const FieldPtr& a, double thickness) {
  if (!(thickness > 0)) throw Error(ErrorKind::bad_input, "shell", "the thickness must be above 0 mm");
  const float half = finite(thickness / 2, "shell");
  return intersect(std::make_shared<Linear>(a, 1.0F, -half), std::make_shared<Linear>(a, -1.0F, -half));
}

FieldPtr blend(FieldPtr a, FieldPtr b, double radius) {
  if (!(radius > 0)) throw Error(ErrorKind::bad_input, "blend", "the radius must be above 0 mm");
  return combined(std::move(a), std::move(b), Blend{std::sqrt(finite(radius, "blend"))});
}

FieldPtr morph(FieldPtr a, FieldPtr b, double weight) {
  const float second = finite(weight, "morph");
  return combined(std::move(a), std::move(b), Morph{1 - second, second});
}

FieldPtr scaled_values(FieldPtr a, double factor) {
  return std::make_shared<Linear>(std::move(a), finite(factor, "scale"), 0.0F);
}

FieldPtr with_known_bounds(FieldPtr a, const Box& bounds) { return std::make_shared<Bounded>(std::move(a), bounds); }

FieldPtr box_field(const Box& box) {
  if (!box.valid()) throw Error(ErrorKind::bad_input, "box", "the bounds must be finite and in order");
  return std::make_shared<BoxField>(box);
}

}  // namespace fieldfab
