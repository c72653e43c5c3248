// Operations that move points: affine placements and the general map.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "chunk.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "interval_sums.h"

namespace fieldfab {
namespace {

/// A Field evaluated at moved points. `Map` moves points, boxes and directions.
template <class Map>
class Moved : public Field {
 public:
  Moved(FieldPtr a, Map map) : a_(std::move(a)), map_(std::move(map)) {}

  void values(const Points& points, float* out) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk x, y, z;
      a_->values(map_.points(part, x, y, z), out + first);
    });
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk x, y, z;
      const Gradients mine{slopes.dx + first, slopes.dy + first, slopes.dz + first};
      a_->gradients(map_.points(part, x, y, z), out + first, mine);
      for (std::size_t i = 0; i < part.count; ++i) {
        const Eigen::Vector3f slope =
            map_.slope({part.x[i], part.y[i], part.z[i]}, {mine.dx[i], mine.dy[i], mine.dz[i]});
        mine.dx[i] = slope.x(), mine.dy[i] = slope.y(), mine.dz[i] = slope.z();
      }
    });
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return a_->interval(map_.box(box)); }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    map_.slopes(*a_, box, directions, out);
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    std::vector<Box> inner;
    for (const Box& box : boxes) inner.push_back(map_.box(box));
    a_->restrict_all(inner, purpose, out);
    for (Restriction& here : out.first(boxes.size())) {
      if (here.field == a_)
        here.field = *this;
      else
        here.field = over(std::move(here.field));
    }
  }
  [[nodiscard]] bool sampled() const noexcept override { return a_->sampled(); }
  [[nodiscard]] bool smooth() const noexcept override { return a_->smooth(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return a_->cost() + 18; }

 protected:
  /// Returns the same map of another Field.
  [[nodiscard]] virtual FieldPtr over(FieldPtr other) const = 0;

  FieldPtr a_;
  Map map_;
};

/// matrix * p + shift.
struct AffineMap {
  explicit AffineMap(const Eigen::Affine3d& map) : to_inner(map), rows(map.matrix().topRows<3>().cast<float>()) {}

  Points points(const Points& part, Chunk& x, Chunk& y, Chunk& z) const noexcept {
    const std::array<Chunk*, 3> to{&x, &y, &z};
    for (int row = 0; row < 3; ++row)
      for (std::size_t i = 0; i < part.count; ++i)
        (*to[static_cast<std::size_t>(row)])[i] =
            ((rows(row, 0) * part.x[i] + rows(row, 1) * part.y[i]) + rows(row, 2) * part.z[i]) + rows(row, 3);
    return {x.data(), y.data(), z.data(), part.count};
  }
  /// Returns the box of the moved points of a box. The sums have the same order as in points(), so
  /// that rounding is the same.
  [[nodiscard]] Box box(const Box& box) const {
    Box inner;
    for (int row = 0; row < 3; ++row) {
      float lower = 0, upper = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const float l = rows(row, axis) * static_cast<float>(box.lower[axis]),
                    u = rows(row, axis) * static_cast<float>(box.upper[axis]);
        const bool unknown = l != l || u != u;  // 0 * infinity
        const float least = unknown ? (rows(row, axis) == 0 ? 0 : -INFINITY) : std::min(l, u);
        const float most = unknown ? (rows(row, axis) == 0 ? 0 : INFINITY) : std::max(l, u);
        lower = axis == 0 ? least : lower + least;
        upper = axis == 0 ? most : upper + most;
      }
      inner.lower[row] = lower + rows(row, 3);
      inner.upper[row] = upper + rows(row, 3);
    }
    return inner;
  }
  [[nodiscard]] Eigen::Vector3f slope(const Eigen::Vector3f& /*at*/, const Eigen::Vector3f& inner) const {
    return {rows.col(0).dot(inner), rows.col(1).dot(inner), rows.col(2).dot(inner)};
  }
  void slopes(const Field& inner, const Box& outer, std::span<const Vec3> directions,
              std::span<Interval> out) const noexcept {
    for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
      std::array<Vec3, slope_lanes> turned;
      for (std::size_t i = 0; i < some.size(); ++i) turned[i] = to_inner.linear() * some[i];
      inner.slopes(box(outer), {turned.data(), some.size()}, out.subspan(first));
    });
  }

  Eigen::Affine3d to_inner;
  Eigen::Matrix<float, 3, 4> rows;
};

/// A Field placed by the inverse of an affine map.
class Affine final : public Moved<AffineMap> {
 public:
  using Moved::Moved;

  [[nodiscard]] Box known_bounds() const noexcept override {
    const Box inner = a_->known_bounds();
    if (!inner.valid()) return Box::everything();
    const Eigen::Affine3d to_outer = map_.to_inner.inverse();
    return image_of(inner, to_outer.linear(), to_outer.translation());
  }
  using Field::framed;
  [[nodiscard]] Framed framed(Purpose purpose) const override {
    Framed inner = a_->framed(purpose);
    const Eigen::Affine3d to_outer = map_.to_inner.inverse();
    return {std::move(inner.field), to_outer.linear() * inner.axes, to_outer * inner.origin};
  }
  [[nodiscard]] bool affine() const noexcept override { return a_->affine(); }
  /// Translations, mirrors and scalings along the axes keep a lattice; rotations do not.
  [[nodiscard]] std::optional<Sampling> sampling() const noexcept override {
    std::optional<Sampling> samples = a_->sampling();
    if (!samples || !keeps_axes()) return std::nullopt;
    const Eigen::Affine3d to_outer = map_.to_inner.inverse();
    samples->origin = to_outer * samples->origin;
    samples->spacing = (to_outer.linear() * samples->spacing).cwiseAbs();
    return samples;
  }
  [[nodiscard]] bool faceted() const noexcept override { return a_->faceted(); }
  bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept override {
    const std::size_t first = directions.size();
    const bool known = a_->facing(map_.box(box), directions);
    for (std::size_t i = first; i < directions.size(); ++i)
      directions[i] = map_.slope(Eigen::Vector3f::Zero(), directions[i]).normalized();
    return known;
  }
  [[nodiscard]] bool corners_tell(const Box& box) const noexcept override {
    return a_->affine() || (keeps_axes() && a_->corners_tell(map_.box(box)));
  }

 private:
  [[nodiscard]] bool keeps_axes() const { return map_.to_inner.linear().isDiagonal(1e-12); }
  [[nodiscard]] FieldPtr over(FieldPtr other) const override {
    return std::make_shared<Affine>(std::move(other), map_);
  }
};

/// Perspective: scales x and y towards an axis along z through a centre, more at greater height,
/// and so converts apparent to true positions for an eye above.
struct EyeMap {
  Eigen::Vector3f centre;
  float inverse_distance;

  /// Ratio of true to apparent distance from the axis at height z.
  [[nodiscard]] float nearness(float z) const { return 1 - (z - centre.z()) * inverse_distance; }

  Points points(const Points& part, Chunk& x, Chunk& y, Chunk& /*z*/) const noexcept {
    for (std::size_t i = 0; i < part.count; ++i) {
      const float near = nearness(part.z[i]);
      x[i] = (part.x[i] - centre.x()) * near + centre.x();
      y[i] = (part.y[i] - centre.y()) * near + centre.y();
    }
    return {x.data(), y.data(), part.z, part.count};
  }
  /// Each step of points() is monotone in each of its arguments, with rounding.
  [[nodiscard]] Box box(const Box& box) const {
    const float far = nearness(static_cast<float>(box.lower.z())), near = nearness(static_cast<float>(box.upper.z()));
    Box inner = box;
    for (int axis = 0; axis < 2; ++axis) {
      const float l = static_cast<float>(box.lower[axis]) - centre[axis],
                  u = static_cast<float>(box.upper[axis]) - centre[axis];
      const auto [least, most] = std::minmax({l * far, l * near, u * far, u * near});
      inner.lower[axis] = least + centre[axis];
      inner.upper[axis] = most + centre[axis];
    }
    return inner;
  }
  [[nodiscard]] Eigen::Vector3f slope(const Eigen::Vector3f& at, const Eigen::Vector3f& inner) const {
    const Eigen::Vector2f sideways = (at - centre).head<2>() * inverse_distance;
    const float near = nearness(at.z());
    return {inner.x() * near, inner.y() * near, inner.z() - sideways.dot(inner.head<2>())};
  }
  /// Unknown: rendering does not need them.
  static void slopes(const Field& /*inner*/, const Box& /*outer*/, std::span<const Vec3> directions,
                     std::span<Interval> out) noexcept {
    std::fill_n(out.begin(), directions.size(), Interval::unknown());
  }
};

class SeenFromNear final : public Moved<EyeMap> {
 public:
  using Moved::Moved;

 private:
  [[nodiscard]] FieldPtr over(FieldPtr other) const override {
    return std::make_shared<SeenFromNear>(std::move(other), map_);
  }
};

/// a(x(p), y(p), z(p)).
class Mapped final : public Field {
 public:
  Mapped(FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z)
      : a_(std::move(a)), coordinate_{std::move(x), std::move(y), std::move(z)} {}

  void values(const Points& points, float* out) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      std::array<Chunk, 3> inner;
      for (std::size_t i = 0; i < 3; ++i) coordinate_[i]->values(part, inner[i].data());
      a_->values({inner[0].data(), inner[1].data(), inner[2].data(), part.count}, out + first);
    });
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      std::array<Chunk, 3> inner, dx, dy, dz;
      for (std::size_t i = 0; i < 3; ++i)
        coordinate_[i]->gradients(part, inner[i].data(), {dx[i].data(), dy[i].data(), dz[i].data()});
      Chunk da, db, dc;
      a_->gradients({inner[0].data(), inner[1].data(), inner[2].data(), part.count}, out + first,
                    {da.data(), db.data(), dc.data()});
      for (std::size_t i = 0; i < part.count; ++i) {
        slopes.dx[first + i] = da[i] * dx[0][i] + db[i] * dx[1][i] + dc[i] * dx[2][i];
        slopes.dy[first + i] = da[i] * dy[0][i] + db[i] * dy[1][i] + dc[i] * dy[2][i];
        slopes.dz[first + i] = da[i] * dz[0][i] + db[i] * dz[1][i] + dc[i] * dz[2][i];
      }
    });
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    std::array<Interval, 3> range;
    for (std::size_t i = 0; i < 3; ++i) range[i] = coordinate_[i]->interval(box);
    return inner_interval(range, a_->interval(inner_box(range)));
  }
  /// Mean-value form of the chain rule: a step from p to q moves the inner point along each of its
  /// three axes.
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    std::array<Interval, 3> range;
    for (std::size_t i = 0; i < 3; ++i) range[i] = coordinate_[i]->interval(box);
    std::array<Interval, 3> inner;
    const std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    a_->slopes(inner_box(range), axes, inner);
    for_few(directions, [&](std::span<const Vec3> some, std::size_t first) {
      std::array<std::array<Interval, slope_lanes>, 3> moves;
      for (std::size_t axis = 0; axis < 3; ++axis) coordinate_[axis]->slopes(box, some, moves[axis]);
      for (std::size_t i = 0; i < some.size(); ++i) {
        Interval sum = Interval::of(0);
        for (std::size_t axis = 0; axis < 3; ++axis) sum = plus(sum, times(inner[axis], moves[axis][i]));
        out[first + i] = sum;
      }
    });
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    std::array<std::vector<Restriction>, 3> coordinate;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinate[axis].resize(boxes.size());
      coordinate_[axis]->restrict_all(boxes, Purpose::value, coordinate[axis]);
    }
    const auto ranges = [&](std::size_t i) {
      return std::array{coordinate[0][i].range, coordinate[1][i].range, coordinate[2][i].range};
    };
    std::vector<Box> inner;
    for (std::size_t i = 0; i < boxes.size(); ++i) inner.push_back(inner_box(ranges(i)));
    a_->restrict_all(inner, purpose, out);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      Restriction& here = out[i];
      const Interval known = inner_interval(ranges(i), here.range);
      // A coordinate may be NaN, and no box contains NaN.
      if (known.maybe_nan && !here.range.maybe_nan) here.field = *a_;
      bool same = here.field == a_;
      for (std::size_t axis = 0; axis < 3; ++axis) same = same && coordinate[axis][i].field == coordinate_[axis];
      here.range = known;
      if (same)
        here.field = *this;
      else
        here.field = std::make_shared<Mapped>(std::move(here.field), std::move(coordinate[0][i].field),
                                              std::move(coordinate[1][i].field), std::move(coordinate[2][i].field));
    }
  }
  [[nodiscard]] bool smooth() const noexcept override {
    return a_->smooth() ||
           std::any_of(coordinate_.begin(), coordinate_.end(), [](const FieldPtr& field) { return field->smooth(); });
  }
  [[nodiscard]] std::size_t cost() const noexcept override {
    return a_->cost() + coordinate_[0]->cost() + coordinate_[1]->cost() + coordinate_[2]->cost();
  }

 private:
  static Box inner_box(const std::array<Interval, 3>& range) {
    return {{range[0].lower, range[1].lower, range[2].lower}, {range[0].upper, range[1].upper, range[2].upper}};
  }
  static Interval inner_interval(const std::array<Interval, 3>& range, Interval inner) {
    if (range[0].maybe_nan || range[1].maybe_nan || range[2].maybe_nan) return Interval::unknown();
    return inner;
  }

  FieldPtr a_;
  std::array<FieldPtr, 3> coordinate_;
};

}  // namespace

FieldPtr transform(FieldPtr a, const Eigen::Affine3d& placement) {
  const double determinant = placement.linear().determinant();
  if (!placement.matrix().allFinite() || !std::isfinite(determinant) || determinant == 0)
    throw Error(ErrorKind::bad_input, "transform", "a placement must be finite and invertible");
  return std::make_shared<Affine>(std::move(a), AffineMap(placement.inverse()));
}

FieldPtr translate(FieldPtr a, const Vec3& by) {
  return transform(std::move(a), Eigen::Affine3d(Eigen::Translation3d(by)));
}

FieldPtr scale(FieldPtr a, const Vec3& factors) {
  if ((factors.array() == 0).any()) throw Error(ErrorKind::bad_input, "scale", "no factor may be 0");
  return scaled_values(transform(std::move(a), Eigen::Affine3d(Eigen::Scaling(factors))),
                       factors.cwiseAbs().minCoeff());
}

FieldPtr rotate(FieldPtr a, const Vec3& axis, double angle) {
  if (!(axis.norm() > 0)) throw Error(ErrorKind::bad_input, "rotate", "the axis must have a length");
  return transform(std::move(a), Eigen::Affine3d(Eigen::AngleAxisd(angle, axis.normalized())));
}

FieldPtr mirror(FieldPtr a, const Vec3& normal) {
  if (!(normal.norm() > 0)) throw Error(ErrorKind::bad_input, "mirror", "the normal must have a length");
  const Vec3 n = normal.normalized();
  Eigen::Affine3d reflection = Eigen::Affine3d::Identity();
  reflection.linear() -= 2 * n * n.transpose();
  return transform(std::move(a), reflection);
}

FieldPtr seen_from_near(FieldPtr a, const Vec3& centre, double distance) {
  if (!centre.allFinite() || !(distance > 0))
    throw Error(ErrorKind::bad_input, "eye", "must be above the centre, at a finite place");
  return std::make_shared<SeenFromNear>(std::move(a), EyeMap{centre.cast<float>(), static_cast<float>(1 / distance)});
}

FieldPtr map(FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z) {
  return std::make_shared<Mapped>(std::move(a), std::move(x), std::move(y), std::move(z));
}

}  // namespace fieldfab
