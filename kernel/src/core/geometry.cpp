#include "fieldfab/core/geometry.h"

namespace fieldfab {

double Box::diagonal() const { return size().norm(); }

bool Box::valid() const { return lower.allFinite() && upper.allFinite() && (lower.array() <= upper.array()).all(); }

Box Box::grown(double margin) const { return {lower.array() - margin, upper.array() + margin}; }

bool Box::operator==(const Box& other) const { return lower == other.lower && upper == other.upper; }

Box intersection(const Box& a, const Box& b) { return {a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)}; }

Box hull(const Box& a, const Box& b) { return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)}; }

Box image_of(const Box& box, const Eigen::Matrix3d& axes, const Vec3& origin) {
  const Vec3 centre = origin + axes * box.centre(), half = axes.cwiseAbs() * (0.5 * box.size());
  return {centre - half, centre + half};
}

}  // namespace fieldfab
