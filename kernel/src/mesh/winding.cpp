#include "winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "triangle_tree.h"

namespace fieldfab {
namespace {

constexpr std::uint32_t most_in_group = 8;
constexpr double far_away = 2.3;  // in radii: beyond this distance a group counts as one dipole

Vec3 area_of(const std::array<Vec3, 3>& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]); }

/// Solid angle of a triangle seen from a point, over 4 pi (Van Oosterom and Strackee 1983).
double share_of_view(const std::array<Vec3, 3>& triangle, const Vec3& point) {
  const Vec3 a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return std::atan2(numerator, denominator) / (2 * std::numbers::pi);
}

}  // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh) : triangles_(corners_of_all(mesh)) {
  groups_.reserve(triangles_.size() / 2);
  divide(0, static_cast<std::uint32_t>(triangles_.size()));
}

void WindingNumber::divide(std::uint32_t first, std::uint32_t count) {
  const std::size_t here = groups_.size();
  Group group{Vec3::Zero(), Vec3::Zero(), 0, 0, first, count};
  Box box{Vec3::Constant(std::numeric_limits<double>::infinity()),
          Vec3::Constant(-std::numeric_limits<double>::infinity())};
  const auto begin = triangles_.begin() + first, end = begin + count;
  for (auto t = begin; t != end; ++t) {
    const Vec3 area = area_of(*t), centre = centre_of(*t);
    group.areas += area;
    group.area += area.norm();
    group.centre += area.norm() * centre;
    box = {box.lower.cwiseMin(centre), box.upper.cwiseMax(centre)};
  }
  group.centre = group.area > 0 ? Vec3(group.centre / group.area) : box.centre();
  for (auto t = begin; t != end; ++t)
    for (const Vec3& corner : *t) group.radius = std::max(group.radius, (corner - group.centre).norm());
  groups_.push_back(group);
  if (count <= most_in_group) return;
  Eigen::Index axis = 0;
  box.size().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end,
                   [axis](const auto& a, const auto& b) { return centre_of(a)[axis] < centre_of(b)[axis]; });
  divide(first, half);
  groups_[here].second = static_cast<std::uint32_t>(groups_.size());
  divide(first + half, count - half);
}

double WindingNumber::at(const Vec3& point) const {
  double number = 0;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  for (open[count++] = 0; count > 0;) {
    const std::uint32_t here = open[--count];
    const Group& group = groups_[here];
    const Vec3 to = group.centre - point;
    const double distance = to.norm();
    if (distance > far_away * group.radius) {
      number += group.areas.dot(to) / (4 * std::numbers::pi * distance * distance * distance);
    } else if (group.second != 0) {
      open[count++] = group.second;
      open[count++] = here + 1;
    } else {
      for (std::uint32_t i = group.first; i < group.first + group.count; ++i)
        number += share_of_view(triangles_[i], point);
    }
  }
  return number;
}

double WindingNumber::steepest(const Vec3& point, double reach) const {
  double sum = 0;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  for (open[count++] = 0; count > 0;) {
    const std::uint32_t here = open[--count];
    const Group& group = groups_[here];
    const double nearest = (group.centre - point).norm() - group.radius - reach;
    if (nearest > 2 * group.radius) {
      sum += group.area / (2 * std::numbers::pi * nearest * nearest * nearest);
    } else if (group.second != 0) {
      open[count++] = group.second;
      open[count++] = here + 1;
    } else {
      for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
        // The nearest point of a triangle is at least as far as that of its bounding ball.
        const Vec3 centre = centre_of(triangles_[i]);
        double radius = 0;
        for (const Vec3& corner : triangles_[i]) radius = std::max(radius, (corner - centre).norm());
        const double gap = (centre - point).norm() - radius - reach;
        if (!(gap > 0)) return std::numeric_limits<double>::infinity();
        sum += area_of(triangles_[i]).norm() / (2 * std::numbers::pi * gap * gap * gap);
      }
    }
  }
  return sum;
}

}  // namespace fieldfab
