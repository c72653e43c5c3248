/// Axis values from tool poses.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "fieldfab/cam/machine/machine.h"

namespace fieldfab::cam {

/// Position of the axes.
struct AxisPose {
  Vec3 position = Vec3::Zero();        ///< x, y and z, mm
  std::array<double, 2> angles{0, 0};  ///< of the rotary axes, radians
};

/// Inverse kinematics of a machine.
class PoseSolver {
 public:
  explicit PoseSolver(const Kinematics& kinematics) : k_(kinematics) {}
  [[nodiscard]] bool tilts() const { return k_.kind != Kinematics::Kind::none; }
  [[nodiscard]] const std::vector<RotaryAxis>& axes() const { return k_.axes; }

  /// Axis values for a tip at `tip` with the tool along `axis` (from the tip towards the spindle),
  /// `length` mm from tip to gauge line. Of several solutions, the one with the least rotation from
  /// `last`. Throws Error(bad_input) if the machine cannot reach the direction.
  [[nodiscard]] AxisPose solve(const Vec3& tip, const Vec3& axis, double length,
                               const std::optional<AxisPose>& last) const;
  /// x, y and z for a tip with given angles of the rotary axes.
  [[nodiscard]] Vec3 position(const Vec3& tip, const std::array<double, 2>& angles, double length) const;
  /// Forward kinematics: tip and axis of a pose.
  [[nodiscard]] std::pair<Vec3, Vec3> pose(const AxisPose& axes, double length) const;
  /// Transformation from the part's coordinates at rest to those of the rotated table.
  [[nodiscard]] Eigen::Isometry3d table(const std::array<double, 2>& angles) const;

 private:
  [[nodiscard]] std::vector<std::array<double, 2>> angles_for(const Vec3& axis) const;
  [[nodiscard]] Vec3 tool_axis(const std::array<double, 2>& angles) const;
  [[nodiscard]] Vec3 swing(const std::array<double, 2>& angles, double length) const;
  const Kinematics& k_;
};

}  // namespace fieldfab::cam
