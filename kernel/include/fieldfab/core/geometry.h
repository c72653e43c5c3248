/// Points and axis-aligned boxes in millimetres, over Eigen's vectors. Eigen's expression templates stay out of this
/// header: each file that includes it would compile them again, which takes a third of a second in all.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace fieldfab {

/// A point or a direction in model space, mm.
using Vec3 = Eigen::Vector3d;

/// A closed axis-aligned box. `lower` may equal `upper` on an axis: the box is then flat, such as the plane of a
/// bitmap.
struct Box {
  Vec3 lower = {0, 0, 0};
  Vec3 upper = {0, 0, 0};

  [[nodiscard]] Vec3 size() const { return {upper.x() - lower.x(), upper.y() - lower.y(), upper.z() - lower.z()}; }
  [[nodiscard]] Vec3 centre() const {
    return {0.5 * (lower.x() + upper.x()), 0.5 * (lower.y() + upper.y()), 0.5 * (lower.z() + upper.z())};
  }
  /// Length of the space diagonal, mm.
  [[nodiscard]] double diagonal() const;
  /// Whether the closed box contains `p`. False if a coordinate is NaN.
  [[nodiscard]] bool contains(const Vec3& p) const {
    return p.x() >= lower.x() && p.y() >= lower.y() && p.z() >= lower.z() && p.x() <= upper.x() && p.y() <= upper.y() &&
           p.z() <= upper.z();
  }
  /// Whether all bounds are finite and lower <= upper on each axis.
  [[nodiscard]] bool valid() const;
  /// Returns the box with each face moved outward by `margin` mm (inward if negative; the result may then be invalid).
  [[nodiscard]] Box grown(double margin) const;

  /// Returns the box that contains all of space.
  static Box everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }
  bool operator==(const Box& other) const;
};

/// Returns the intersection of two boxes. The result is not valid() if they are disjoint.
Box intersection(const Box& a, const Box& b);

/// Returns the smallest box that contains both boxes.
Box hull(const Box& a, const Box& b);

/// Returns the bounding box of the affine image {origin + axes * u : u in box}. `axes` has one image of a unit vector
/// per column.
Box image_of(const Box& box, const Eigen::Matrix3d& axes, const Vec3& origin);

}  // namespace fieldfab
