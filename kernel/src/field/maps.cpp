// Operations that move points: affine placements and the general map.
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "chunk.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab {
namespace {

/// a(matrix * p + shift): the Field placed by the inverse of that map.
class Affine final : public Field {
 public:
  Affine(FieldPtr a, const Eigen::Affine3d& to_inner)
      : a_(std::move(a)), to_inner_(to_inner), rows_(to_inner.matrix().topRows<3>().cast<float>()) {}

  void values(const Points& points, float* out) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk x, y, z;
      a_->values(moved(part, x, y, z), out + first);
    });
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk x, y, z;
      const Gradients mine{slopes.dx + first, slopes.dy + first, slopes.dz + first};
      a_->gradients(moved(part, x, y, z), out + first, mine);
      for (std::size_t i = 0; i < part.count; ++i) {
        const Eigen::Vector3f inner(mine.dx[i], mine.dy[i], mine.dz[i]);
        mine.dx[i] = rows_.col(0).dot(inner);
        mine.dy[i] = rows_.col(1).dot(inner);
        mine.dz[i] = rows_.col(2).dot(inner);
      }
    });
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return a_->interval(moved(box)); }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    std::vector<Box> inner;
    for (const Box& box : boxes) inner.push_back(moved(box));
    a_->restrict_all(inner, purpose, out);
    for (Restriction& here : out.first(boxes.size()))
      here.field = here.field == a_ ? shared_from_this() : std::make_shared<Affine>(std::move(here.field), to_inner_);
  }
  [[nodiscard]] Box known_bounds() const noexcept override {
    const Box inner = a_->known_bounds();
    if (!inner.valid()) return Box::everything();
    const Eigen::Affine3d to_outer = to_inner_.inverse();
    return image_of(inner, to_outer.linear(), to_outer.translation());
  }
  [[nodiscard]] Framed framed() const override {
    Framed inner = a_->framed();
    const Eigen::Affine3d to_outer = to_inner_.inverse();
    return {std::move(inner.field), to_outer.linear() * inner.axes, to_outer * inner.origin};
  }
  [[nodiscard]] bool affine() const noexcept override { return a_->affine(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return a_->cost() + 18; }

 private:
  Points moved(const Points& part, Chunk& x, Chunk& y, Chunk& z) const noexcept {
    const std::array<Chunk*, 3> to{&x, &y, &z};
    for (int row = 0; row < 3; ++row)
      for (std::size_t i = 0; i < part.count; ++i)
        (*to[static_cast<std::size_t>(row)])[i] =
            ((rows_(row, 0) * part.x[i] + rows_(row, 1) * part.y[i]) + rows_(row, 2) * part.z[i]) + rows_(row, 3);
    return {x.data(), y.data(), z.data(), part.count};
  }
  /// The box of the moved points of a box: the same sums in the same order, so that rounding goes the same way.
  [[nodiscard]] Box moved(const Box& box) const {
    Box inner;
    for (int row = 0; row < 3; ++row) {
      float lower = 0, upper = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const float l = rows_(row, axis) * static_cast<float>(box.lower[axis]),
                    u = rows_(row, axis) * static_cast<float>(box.upper[axis]);
        const bool unknown = l != l || u != u;  // 0 * infinity
        const float least = unknown ? (rows_(row, axis) == 0 ? 0 : -INFINITY) : std::min(l, u);
        const float most = unknown ? (rows_(row, axis) == 0 ? 0 : INFINITY) : std::max(l, u);
        lower = axis == 0 ? least : lower + least;
        upper = axis == 0 ? most : upper + most;
      }
      inner.lower[row] = lower + rows_(row, 3);
      inner.upper[row] = upper + rows_(row, 3);
    }
    return inner;
  }

  FieldPtr a_;
  Eigen::Affine3d to_inner_;
  Eigen::Matrix<float, 3, 4> rows_;
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
      if (known.maybe_nan && !here.range.maybe_nan) here.field = a_;  // a coordinate may be NaN, which no box holds
      bool same = here.field == a_;
      for (std::size_t axis = 0; axis < 3; ++axis) same = same && coordinate[axis][i].field == coordinate_[axis];
      here.range = known;
      here.field = same ? shared_from_this()
                        : std::make_shared<Mapped>(std::move(here.field), std::move(coordinate[0][i].field),
                                                   std::move(coordinate[1][i].field), std::move(coordinate[2][i].field));
    }
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
  return std::make_shared<Affine>(std::move(a), placement.inverse());
}

FieldPtr translate(FieldPtr a, const Vec3& by) { return transform(std::move(a), Eigen::Affine3d(Eigen::Translation3d(by))); }

FieldPtr scale(FieldPtr a, const Vec3& factors) {
  if ((factors.array() == 0).any()) throw Error(ErrorKind::bad_input, "scale", "no factor may be 0");
  return scaled_values(transform(std::move(a), Eigen::Affine3d(Eigen::Scaling(factors))), factors.cwiseAbs().minCoeff());
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

FieldPtr map(FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z) {
  return std::make_shared<Mapped>(std::move(a), std::move(x), std::move(y), std::move(z));
}

}  // namespace fieldfab
