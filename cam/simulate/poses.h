/// Tool poses relative to the part, from axis values.
#pragma once

#include <vector>

#include "fieldfab/cam/simulate/setup.h"
#include "machine/kinematics.h"

namespace fieldfab::cam {

/// Poses of the tool relative to the part along motions of the axes.
class PoseMaker {
 public:
  PoseMaker(const SimulationSetup& setup, const std::string& program);

  /// The pose for axis values. `lengthened`: difference between the control's length offset and the
  /// tool's length, mm; `length`: the tool's length, mm.
  [[nodiscard]] ToolPose pose(const AxisValues& axes, ControlMode mode, double lengthened, double length,
                              const Placement& placement) const;
  /// Throws Error(bad_input) with the line if a motion turns an axis that the machine does not
  /// have.
  void check(const Motion& motion) const;
  /// Axis values between which a motion is linear in all axes, starting with `from`; several for a
  /// dog-leg or an arc.
  [[nodiscard]] std::vector<AxisValues> places(const AxisValues& from, const Motion& motion, double tolerance) const;
  /// Poses along a sequence of axis values, so dense that tip and axis may be interpolated linearly
  /// between them: the error of any point of the tool up to `reach` above its tip is at most
  /// `tolerance`. Starts with the pose of the first values.
  [[nodiscard]] std::vector<ToolPose> along(const std::vector<AxisValues>& places, ControlMode mode, double lengthened,
                                            double length, const Placement& placement, double reach,
                                            double tolerance) const;

 private:
  const SimulationSetup& setup_;
  std::string program_;
  Kinematics kinematics_, tip_kinematics_;
  std::array<std::size_t, 2> rotary_{};  ///< indices of the machine's rotary axes among the axis values
};

}  // namespace fieldfab::cam
