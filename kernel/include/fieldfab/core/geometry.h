/// Points and boxes in millimetres. Eigen gives the vectors; nothing here evaluates a shape. Eigen's expressions stay out of this
/// file: each file that includes it would compile them anew, a third of a second in all.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace fieldfab {

/// A point or direction in model space, in millimetres.
using Vec3 = Eigen::Vector3d;

/// A closed axis-aligned box. `lower` may equal `upper` on an axis: a flat region, such as the plane of a bitmap.
struct Box {
  Vec3 lower = {0, 0, 0};
  Vec3 upper = {0, 0, 0};

  [[nodiscard]] Vec3 size() const { return {upper.x() - lower.x(), upper.y() - lower.y(), upper.z() - lower.z()}; }
  [[nodiscard]] Vec3 centre() const {
    return {0.5 * (lower.x() + upper.x()), 0.5 * (lower.y() + upper.y()), 0.5 * (lower.z() + upper.z())};
  }
  /// Length of the space diagonal, mm.
  [[nodiscard]] double diagonal() const;
  [[nodiscard]] bool contains(const Vec3& p) const {
    return p.x() >= lower.x() && p.y() >= lower.y() && p.z() >= lower.z() && p.x() <= upper.x() && p.y() <= upper.y() &&
           p.z() <= upper.z();
  }
  /// All bounds finite and no axis reversed.
  [[nodiscard]] bool valid() const;
  /// The box moved outward by `margin` mm on every side (inward where negative).
  [[nodiscard]] Box grown(double margin) const;

  /// The box of all of space.
  static Box everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }
  bool operator==(const Box& other) const;
};

/// The box common to both; not valid() where they do not meet.
Box intersection(const Box& a, const Box& b);

/// The smallest box that holds both.
Box hull(const Box& a, const Box& b);

/// The smallest box that holds the points origin + axes * u of all u in a box.
Box image_of(const Box& box, const Eigen::Matrix3d& axes, const Vec3& origin);

}  // namespace fieldfab
