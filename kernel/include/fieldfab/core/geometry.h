/// Points and boxes in millimetres. Eigen gives the vectors; nothing here evaluates a shape.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace fieldfab {

/// A point or direction in model space, in millimetres.
using Vec3 = Eigen::Vector3d;

/// A closed axis-aligned box. `lower` may equal `upper` on an axis: a flat region, such as the plane of a bitmap.
struct Box {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();

  [[nodiscard]] Vec3 size() const { return upper - lower; }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (lower + upper); }
  /// Length of the space diagonal, mm.
  [[nodiscard]] double diagonal() const { return size().norm(); }
  [[nodiscard]] bool contains(const Vec3& p) const {
    return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
  }
  /// All bounds finite and no axis reversed.
  [[nodiscard]] bool valid() const { return lower.allFinite() && upper.allFinite() && (lower.array() <= upper.array()).all(); }
  /// The box moved outward by `margin` mm on every side (inward where negative).
  [[nodiscard]] Box grown(double margin) const { return {lower.array() - margin, upper.array() + margin}; }

  /// The box of all of space.
  static Box everything() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {Vec3::Constant(-inf), Vec3::Constant(inf)};
  }
  bool operator==(const Box& other) const { return lower == other.lower && upper == other.upper; }
};

/// The box common to both; not valid() where they do not meet.
inline Box intersection(const Box& a, const Box& b) { return {a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)}; }

/// The smallest box that holds both.
inline Box hull(const Box& a, const Box& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

/// The smallest box that holds the points origin + axes * u of all u in a box.
inline Box image_of(const Box& box, const Eigen::Matrix3d& axes, const Vec3& origin) {
  const Vec3 centre = origin + axes * box.centre(), half = axes.cwiseAbs() * (0.5 * box.size());
  return {centre - half, centre + half};
}

}  // namespace fieldfab
