#include "kinematics.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

Eigen::Matrix3d turn(const RotaryAxis& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.direction).toRotationMatrix();
}

/// Rotation about an axis through a point.
Eigen::Isometry3d turn_about(const RotaryAxis& axis, double angle, const Vec3& point) {
  return Eigen::Translation3d(point) * Eigen::AngleAxisd(angle, axis.direction) * Eigen::Translation3d(-point);
}

/// Solutions t of a cos t + b sin t = c.
std::vector<double> solutions(double a, double b, double c) {
  const double length = std::hypot(a, b);
  if (length < 1e-12) return std::abs(c) < 1e-9 ? std::vector<double>{0} : std::vector<double>{};
  if (std::abs(c) > length * (1 + 1e-9)) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / length, -1.0, 1.0));
  return {middle + half, middle - half};
}

}  // namespace

// Direction of the tool: head axes turn the tool, table axes turn the work the opposite way. In the
// work's coordinates the tool's direction is T1' T2' H1 H2 z, with head rotations H and inverse
// table rotations T'. That is a product of at most two rotations, the outer one first.

Vec3 PoseSolver::tool_axis(const std::array<double, 2>& angles) const {
  if (k_.kind == Kinematics::Kind::head_head) {
    Vec3 v = k_.axes.size() > 1 ? Vec3(turn(k_.axes[1], angles[1]) * Vec3::UnitZ()) : Vec3::UnitZ();
    return turn(k_.axes[0], angles[0]) * v;
  }
  if (k_.kind == Kinematics::Kind::table_table) {
    // The work stands on the second axis, which stands on the first. The rotation from work to bed
    // is R1 R2, so the tool's direction in the work is R2' R1' z.
    Vec3 v = turn(k_.axes[0], -angles[0]) * Vec3::UnitZ();
    return k_.axes.size() > 1 ? Vec3(turn(k_.axes[1], -angles[1]) * v) : v;
  }
  if (k_.kind == Kinematics::Kind::head_table) {
    Vec3 v = turn(k_.axes[0], angles[0]) * Vec3::UnitZ();
    return k_.axes.size() > 1 ? Vec3(turn(k_.axes[1], -angles[1]) * v) : v;
  }
  return Vec3::UnitZ();
}

std::vector<std::array<double, 2>> PoseSolver::angles_for(const Vec3& axis) const {
  if (k_.kind == Kinematics::Kind::none)
    return (axis - Vec3::UnitZ()).norm() < 1e-9 ? std::vector<std::array<double, 2>>{{0, 0}}
                                                : std::vector<std::array<double, 2>>{};
  // axis = Outer(p) Inner(q) z with directions o and i, and signs according to the kind.
  const bool head_outer = k_.kind == Kinematics::Kind::head_head;
  const bool single = k_.axes.size() == 1;
  const Vec3 inner =
      single || head_outer ? (single ? k_.axes[0].direction : k_.axes[1].direction) : k_.axes[0].direction;
  const Vec3 outer = single ? Vec3(Vec3::UnitZ()) : head_outer ? k_.axes[0].direction : k_.axes[1].direction;
  // The outer rotation keeps the component along its own direction: o . axis = o . Inner(q) z.
  const Vec3 z = Vec3::UnitZ();
  const double along = inner.dot(z) * outer.dot(inner);
  const double a = outer.dot(z) - along, b = outer.dot(inner.cross(z)), c = outer.dot(axis) - along;
  std::vector<std::array<double, 2>> found;
  for (const double q : solutions(a, b, c)) {
    const Vec3 v = Eigen::AngleAxisd(q, inner) * z;
    double p = 0;
    const Vec3 from = v - outer.dot(v) * outer, to = axis - outer.dot(axis) * outer;
    if (from.norm() > 1e-9 && to.norm() > 1e-9) p = std::atan2(outer.dot(from.cross(to)), from.dot(to));
    if (single && std::abs(p) > 1e-9) continue;  // the machine has no rotation about z there
    // Signs and order of the machine's own axes.
    if (k_.kind == Kinematics::Kind::head_head)
      found.push_back(single ? std::array<double, 2>{q, 0} : std::array<double, 2>{p, q});
    if (k_.kind == Kinematics::Kind::table_table) found.push_back({-q, -p});
    if (k_.kind == Kinematics::Kind::head_table) found.push_back({q, -p});
  }
  return found;
}

AxisPose PoseSolver::solve(const Vec3& tip, const Vec3& axis, double length,
                           const std::optional<AxisPose>& last) const {
  if (!tilts() && (axis - Vec3::UnitZ()).norm() > 1e-9)
    throw Error(ErrorKind::bad_input, "machine", "this machine cannot tilt the tool");
  const std::array<double, 2> from = last ? last->angles : std::array<double, 2>{0, 0};
  std::optional<std::array<double, 2>> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& angles : angles_for(axis)) {
    std::array<double, 2> turned = angles;
    bool within = true;
    for (std::size_t k = 0; k < k_.axes.size(); ++k) {
      // The equivalent angle nearest to the axis' position within its limits.
      const double full = 2 * std::numbers::pi;
      turned[k] += full * std::round((from[k] - turned[k]) / full);
      while (turned[k] > k_.axes[k].upper + 1e-9) turned[k] -= full;
      while (turned[k] < k_.axes[k].lower - 1e-9) turned[k] += full;
      within &= turned[k] <= k_.axes[k].upper + 1e-9 && turned[k] >= k_.axes[k].lower - 1e-9;
    }
    const double way = std::abs(turned[0] - from[0]) + std::abs(turned[1] - from[1]);
    if (within && way < least - 1e-9) least = way, best = turned;
  }
  if (!best)
    throw Error(ErrorKind::bad_input, "machine",
                fmt::format("the machine cannot point its tool along ({:.4g}, {:.4g}, {:.4g})", -axis.x(), -axis.y(),
                            -axis.z()));
  for (double& angle : *best)
    if (std::abs(angle) < 1e-12) angle = 0;
  return {position(tip, *best, length), *best};
}

Eigen::Isometry3d PoseSolver::table(const std::array<double, 2>& angles) const {
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  for (std::size_t i = k_.kind == Kinematics::Kind::head_head    ? 2
                       : k_.kind == Kinematics::Kind::head_table ? 1
                                                                 : 0;
       i < k_.axes.size(); ++i)
    turned = turned * turn_about(k_.axes[i], angles[i], k_.axes[i].centre.value_or(k_.centre));
  return turned;
}

/// Displacement of a tool's tip by a head's rotations, relative to the vertical tool.
Vec3 PoseSolver::swing(const std::array<double, 2>& angles, double length) const {
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  const std::size_t of_head = k_.kind == Kinematics::Kind::head_head    ? 2
                              : k_.kind == Kinematics::Kind::head_table ? 1
                                                                        : 0;
  for (std::size_t i = 0; i < std::min(of_head, k_.axes.size()); ++i)
    turned = turned * turn_about(k_.axes[i], angles[i],
                                 k_.axes[i].centre.value_or(k_.pivot * Vec3::UnitZ()) + length * Vec3::UnitZ());
  return turned.translation();
}

// x, y and z move the spindle; their origin is the tip's position with a vertical tool.
Vec3 PoseSolver::position(const Vec3& tip, const std::array<double, 2>& angles, double length) const {
  if (k_.tip_mode || !tilts()) return tip;
  return table(angles) * tip - swing(angles, length);
}

std::pair<Vec3, Vec3> PoseSolver::pose(const AxisPose& axes, double length) const {
  const Vec3 axis = tool_axis(axes.angles);
  if (k_.tip_mode || !tilts()) return {axes.position, axis};
  return {table(axes.angles).inverse() * (axes.position + swing(axes.angles, length)), axis};
}

}  // namespace fieldfab::cam
