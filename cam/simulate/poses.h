/// From axis values to the tool's poses on the part.
#pragma once

#include <vector>

#include "fieldfab/cam/simulate/setup.h"
#include "machine/kinematics.h"

namespace fieldfab::cam {

/// Where the tool stands on the part while axes move from one place to another.
class PoseMaker {
 public:
  PoseMaker(const SimulationSetup& setup, const std::string& program);

  /// The pose for axis values. `lengthened`: how much longer than the tool the control takes it for, mm; `length` of the tool.
  [[nodiscard]] ToolPose pose(const AxisValues& axes, ControlMode mode, double lengthened, double length,
                              const Placement& placement) const;
  /// Throws bad_input with the line where a motion turns an axis that the machine does not have.
  void check(const Motion& motion) const;
  /// The places between which a motion is even in all axes' values, beginning with the first: several for a dog-leg or an arc.
  [[nodiscard]] std::vector<AxisValues> places(const AxisValues& from, const Motion& motion, double tolerance) const;
  /// Poses from place to place so dense that between two of them tip and axis may be taken to go evenly: no point of the tool up
  /// to `reach` above its tip is farther than `tolerance` from where it should be. Begins with the first place's pose.
  [[nodiscard]] std::vector<ToolPose> along(const std::vector<AxisValues>& places, ControlMode mode, double lengthened,
                                            double length, const Placement& placement, double reach, double tolerance) const;

 private:
  const SimulationSetup& setup_;
  std::string program_;
  Kinematics kinematics_, tip_kinematics_;
  std::array<std::size_t, 2> rotary_{};  ///< which axis values the machine's rotary axes are
};

}  // namespace fieldfab::cam
