/// Field: the one idea of Fieldfab. A scalar function of a point in millimetres: negative inside, zero on the surface.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/interval.h"

namespace fieldfab {

/// A batch of points as three arrays (structure of arrays), mm. The arrays need no alignment and are only read.
struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t count = 0;

  /// The `length` points from `first` on.
  [[nodiscard]] Points part(std::size_t first, std::size_t length) const { return {x + first, y + first, z + first, length}; }
};

/// Where a batch of gradients is written: d/dx, d/dy, d/dz, each `count` floats.
struct Gradients {
  float* dx = nullptr;
  float* dy = nullptr;
  float* dz = nullptr;
};

class Field;
/// Fields are immutable and shared; every member may be called from many threads at once.
using FieldPtr = std::shared_ptr<const Field>;

/// What a Field is needed for inside a box.
enum class Purpose {
  value,      ///< the restricted Field gives bit for bit the same values, gradients and signs (Keeter Alg. 3.3)
  occupancy,  ///< only the sign has to be the same: more can be pruned (Boolean pruning, Keeter Alg. 3.4)
};

/// A Field confined to a box: its interval there, and a Field, often cheaper, that answers alike inside that box.
struct Restriction {
  Interval range;
  FieldPtr field;  ///< never null; may be the same Field where nothing could be gained
};

/// A Field seen in other coordinates: at `origin + axes * u` the one it comes from has the value that `field` has at u, but for
/// rounding.
struct Framed {
  FieldPtr field;
  Eigen::Matrix3d axes;  ///< its columns; independent, but not always at right angles or of unit length
  Vec3 origin;
};

/// Equally spaced sample points along x, y and z, mm: `origin` + whole multiples of `spacing`, which is positive.
struct Sampling {
  Vec3 origin, spacing;
};

/// A solid, as the sign and value of a function. Points with value < 0 are inside; 0, above and NaN are not.
class Field : public std::enable_shared_from_this<Field> {
 public:
  virtual ~Field() = default;

  /// Writes the value at each point to `out` (`points.count` floats). Never throws; NaN is a value.
  virtual void values(const Points& points, float* out) const noexcept = 0;

  /// Writes the value and the gradient at each point. Where the function has a crease (min, max, abs) the gradient is that of
  /// one of its sides: the side that gives the value, the first argument's on a tie.
  virtual void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept = 0;

  /// An interval that holds every value that values() yields for points of `box` (rounded to float).
  [[nodiscard]] virtual Interval interval(const Box& box) const noexcept = 0;

  /// Bounds on how fast the value changes along each of `directions` in `box`: out[i] holds (f(p + t d) - f(p)) / t for any two
  /// points p and p + t d of the box, with t > 0 and d = directions[i], but for rounding. Stated for differences, not for
  /// derivatives, so that it holds across creases. Interval::unknown() where nothing is known, as by default, where the value
  /// jumps or may be NaN. Value per mm where d is a unit vector.
  virtual void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept;

  /// Whether facing() proves more than slopes() does, as for meshes: the distance to triangles has creases everywhere, while its
  /// sign changes at the triangles alone.
  [[nodiscard]] virtual bool faceted() const noexcept { return false; }

  /// Adds directions (of length 1) to `directions` such that the solid is left at most, and never entered, on any straight way
  /// through `box` that has no negative component along any of them: the outward normals of all of its surface in the box.
  /// Returns false, with any directions added, where they are unknown or more than a few. By default they follow from slopes().
  virtual bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept;

  /// For each box the interval over it and a Field that gives the same answers at every point of it (see Purpose); outside of its
  /// box that Field means nothing. `out` has one place for each box. Several boxes, such as the children of a cell, may cost
  /// little more than one. The default gives intervals, and this Field itself.
  virtual void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const;
  /// restrict_all() for one box.
  [[nodiscard]] Restriction restricted(const Box& box, Purpose purpose = Purpose::value) const;

  /// A box that holds the solid, where the Field knows one from its making; Box::everything() otherwise. See solid_bounds().
  [[nodiscard]] virtual Box known_bounds() const noexcept { return Box::everything(); }

  /// This Field in the coordinates in which its intervals are tightest, where it knows them: what was placed askew is straight
  /// there. By default it is itself, in x, y and z.
  /// For occupancy only the sign has to be the same.
  [[nodiscard]] virtual Framed framed(Purpose purpose) const;
  [[nodiscard]] Framed framed() const { return framed(Purpose::value); }

  /// Whether the function is known to be a + b x + c y + d z, but for rounding: then a few values tell all of them.
  [[nodiscard]] virtual bool affine() const noexcept { return false; }

  /// Whether it is interpolated between samples: its creases then lie where cells meet, and tell nothing about the solid.
  [[nodiscard]] virtual bool sampled() const noexcept { return false; }

  /// The samples between which the function is trilinear, where it has such along x, y and z.
  [[nodiscard]] virtual std::optional<Sampling> sampling() const noexcept { return std::nullopt; }

  /// Whether the signs in `box` are those of a function that is linear along x, y and z each (trilinear), but for rounding: all
  /// are alike where those at the corners are.
  [[nodiscard]] virtual bool corners_tell(const Box& /*box*/) const noexcept { return affine(); }

  /// Whether it is sampled() as far as it is left in a small box, or is joined smoothly with what is sampled: edges there are
  /// noise.
  [[nodiscard]] virtual bool smooth() const noexcept { return sampled(); }

  /// Rough cost of one value, in arithmetic operations: for choosing batch and block sizes and for statistics.
  [[nodiscard]] virtual std::size_t cost() const noexcept { return 1; }

  /// The value at one point: values() for a batch of one.
  [[nodiscard]] float value(const Vec3& point) const noexcept;
  /// The gradient at one point.
  [[nodiscard]] Vec3 gradient(const Vec3& point) const noexcept;

 protected:
  Field() = default;
  Field(const Field&) = default;
  Field& operator=(const Field&) = default;
};

}  // namespace fieldfab
