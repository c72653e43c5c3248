/// Field: the central abstraction of Fieldfab. A scalar function of a point in millimetres, negative inside a solid and
/// zero on its surface.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// A batch of points as a structure of arrays, mm. The arrays are not owned, only read, and need no alignment. They may
/// contain NaN and infinity.
struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t count = 0;

  /// Returns the view of `length` points from index `first` on.
  [[nodiscard]] Points part(std::size_t first, std::size_t length) const {
    return {x + first, y + first, z + first, length};
  }
};

/// Destination of a batch of gradients: d/dx, d/dy and d/dz, each an array of `count` floats, not owned.
struct Gradients {
  float* dx = nullptr;
  float* dy = nullptr;
  float* dz = nullptr;
};

class Field;
class Progress;
struct SolidBounds;
/// Fields are immutable and shared by reference count. Each member may be called from several threads at the same time.
using FieldPtr = std::shared_ptr<const Field>;

/// The guarantee required of a Field restricted to a box.
enum class Purpose {
  value,      ///< the same values, gradients and signs, bit for bit (Keeter, Algorithm 3.3)
  occupancy,  ///< the same sign only, which permits more pruning (Boolean pruning; Keeter, Algorithm 3.4)
};

/// Pointer to the Field of a Restriction. It owns a Field that was made for the box; the original Field it only refers
/// to, and must not outlive: threads that restrict one Field would wait for each other if each box counted as an owner.
/// A FieldPtr made from it always owns.
class RestrictedField {
 public:
  RestrictedField() = default;
  RestrictedField(const Field& original) : field_(&original) {}
  template <class Made>
  RestrictedField(std::shared_ptr<Made> made) : field_(made.get()), owner_(std::move(made)) {}

  const Field* operator->() const { return field_; }
  const Field& operator*() const { return *field_; }
  [[nodiscard]] const Field* get() const { return field_; }
  operator FieldPtr() const&;
  operator FieldPtr() &&;
  bool operator==(const RestrictedField& other) const { return field_ == other.field_; }
  bool operator==(const FieldPtr& other) const { return field_ == other.get(); }

 private:
  const Field* field_ = nullptr;
  FieldPtr owner_;
};

/// Result of restricting a Field to a box: its range, and an equivalent Field that is often cheaper to evaluate there.
struct Restriction {
  Interval range;
  RestrictedField field;  ///< never null; may be the original Field
};

/// A Field in other coordinates: the original has, at `origin + axes * u`, the value of `field` at u, up to rounding.
struct Framed {
  FieldPtr field;
  /// basis vectors as columns; linearly independent, but not necessarily orthogonal or of unit length
  Eigen::Matrix3d axes;
  Vec3 origin;
};

/// Equally spaced sample points along x, y and z, mm: `origin` plus whole multiples of `spacing`, which is positive.
struct Sampling {
  Vec3 origin, spacing;
};

/// A solid, defined by the sign of a function. Points with a negative value are inside. Points with the value 0, a
/// positive value or NaN are not.
class Field : public std::enable_shared_from_this<Field> {
 public:
  virtual ~Field() = default;

  /// Evaluates the function at each point and writes `points.count` floats to `out`. Never throws. Invalid arithmetic
  /// yields NaN, which is outside.
  virtual void values(const Points& points, float* out) const noexcept = 0;

  /// Evaluates the function and its gradient at each point. At a crease (min, max, abs) the gradient is that of the
  /// branch that gives the value; on a tie, that of the first argument.
  virtual void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept = 0;

  /// Returns an interval that contains each value of values() at points of `box` (rounded to float).
  [[nodiscard]] virtual Interval interval(const Box& box) const noexcept = 0;

  /// Bounds the difference quotients along each of `directions` in `box`: out[i] contains (f(p + t d) - f(p)) / t for
  /// any two points p and p + t d of the box, with t > 0 and d = directions[i], up to rounding. The bound concerns
  /// differences rather than derivatives, so that it holds across creases. The unit is value per mm if d is a unit
  /// vector. Yields Interval::unknown() if no bound is known (the default), if the function jumps or if it may be NaN.
  virtual void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept;

  /// Whether facing() proves more than slopes() does. True for meshes: the distance to triangles has creases
  /// everywhere, while its sign changes only at the triangles.
  [[nodiscard]] virtual bool faceted() const noexcept { return false; }

  /// Appends unit vectors to `directions`, the outward normals of all pieces of surface in `box`: a straight way
  /// through the box with no negative component along any of them may leave the solid but never enters it. Returns
  /// false if the normals are unknown or too many; what was appended then has no meaning. The default derives them
  /// from slopes().
  virtual bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept;

  /// Restricts the Field to each box: writes the interval over the box, and a Field with the same answers at each point
  /// of the box (see Purpose). Outside its box that Field is undefined. `out` has one entry per box. Several boxes,
  /// such as the children of a cell, may cost little more than one. The default gives the interval and this Field
  /// itself.
  virtual void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const;
  /// Restricts the Field to one box; see restrict_all().
  [[nodiscard]] Restriction restricted(const Box& box, Purpose purpose = Purpose::value) const;

  /// Returns a box that contains the solid, if the Field knows one by construction; otherwise Box::everything(). Does
  /// not search; see solid_bounds().
  [[nodiscard]] virtual Box known_bounds() const noexcept { return Box::everything(); }

  /// Returns this Field in the coordinates in which its intervals are tightest, if it knows them: a rotated solid is
  /// then axis-aligned. The default is this Field in x, y and z. For Purpose::occupancy only the sign must agree.
  [[nodiscard]] virtual Framed framed(Purpose purpose) const;
  [[nodiscard]] Framed framed() const { return framed(Purpose::value); }

  /// Returns a Field with the same sign everywhere but in seams: gaps and skins without thickness, up to rounding,
  /// where faces of the solid's parts coincide. Null if it finds none, which it may where there are some. Meant for a
  /// Field that was restricted to a small box.
  [[nodiscard]] virtual FieldPtr without_seams() const { return nullptr; }

  /// Whether the function is known to be affine, a + b x + c y + d z up to rounding: a few values then determine all.
  [[nodiscard]] virtual bool affine() const noexcept { return false; }

  /// Axes whose coordinate the function does not read, bit i for axis i. It is the same along them, bit for bit, as an
  /// extrusion is away from its ends. The default is none.
  [[nodiscard]] virtual unsigned unread_axes() const noexcept { return 0; }

  /// Whether the function is interpolated between samples. Its creases then lie on cell faces and are not features of
  /// the solid.
  [[nodiscard]] virtual bool sampled() const noexcept { return false; }

  /// Returns the lattice of samples between which the function is trilinear, if it is axis-aligned; otherwise
  /// std::nullopt.
  [[nodiscard]] virtual std::optional<Sampling> sampling() const noexcept { return std::nullopt; }

  /// Whether the signs in `box` are those of a trilinear function, up to rounding: if all corners have the same sign,
  /// so has the whole box. Axes count by themselves: a box tells if others with its sides along x, y and z do.
  [[nodiscard]] virtual bool corners_tell(const Box& /*box*/) const noexcept { return affine(); }

  /// Whether edges in a small box are noise: the restricted Field is sampled(), or blends smoothly with a sampled
  /// Field.
  [[nodiscard]] virtual bool smooth() const noexcept { return sampled(); }

  /// Approximate cost of one value in arithmetic operations, for the choice of batch and block sizes and for
  /// statistics.
  [[nodiscard]] virtual std::size_t cost() const noexcept { return 1; }

  /// Returns the value at one point, after rounding its coordinates to float. Slower per point than a batch of
  /// values().
  [[nodiscard]] float value(const Vec3& point) const noexcept;
  /// Returns the gradient at one point, after rounding its coordinates to float; value per mm.
  [[nodiscard]] Vec3 gradient(const Vec3& point) const noexcept;

 protected:
  Field() = default;
  Field(const Field& other) : std::enable_shared_from_this<Field>(other) {}
  Field& operator=(const Field&) = delete;

 private:
  friend SolidBounds solid_bounds(const Field& field, Progress& progress);
  mutable std::atomic<std::shared_ptr<const SolidBounds>> bounds_;  // what solid_bounds() found
};

inline RestrictedField::operator FieldPtr() const& { return owner_ ? owner_ : field_->shared_from_this(); }
inline RestrictedField::operator FieldPtr() && { return owner_ ? std::move(owner_) : field_->shared_from_this(); }

}  // namespace fieldfab
