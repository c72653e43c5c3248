#include "poses.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/chords.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

PoseMaker::PoseMaker(const SimulationSetup& setup, const std::string& program)
    : setup_(setup),
      program_(program),
      kinematics_(setup.machine.kinematics),
      tip_kinematics_(setup.machine.kinematics) {
  kinematics_.axes.resize(std::min<std::size_t>(kinematics_.axes.size(), 2));
  tip_kinematics_ = kinematics_;
  tip_kinematics_.tip_mode = true;
  for (std::size_t i = 0; i < kinematics_.axes.size(); ++i) {
    const char letter = kinematics_.axes[i].letter;
    if (letter < 'A' || letter > 'C')
      throw Error(ErrorKind::bad_input, setup.file, fmt::format("a rotary axis is called A, B or C, not '{}'", letter));
    rotary_[i] = static_cast<std::size_t>(letter - 'A') + 3;
  }
}

void PoseMaker::check(const Motion& motion) const {
  for (std::size_t axis = 3; axis < 9; ++axis) {
    const bool known = axis < 6 && ((!kinematics_.axes.empty() && rotary_[0] == axis) ||
                                    (kinematics_.axes.size() > 1 && rotary_[1] == axis));
    if (!known && std::abs(motion.end.at[axis] - setup_.start.at[axis]) > 1e-9)
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", program_, motion.line),
                  fmt::format("it moves {}, an axis that {} does not have", "XYZABCUVW"[axis],
                              setup_.machine.name.empty() ? "the machine" : setup_.machine.name));
  }
}

Eigen::Isometry3d turn_of_work(const Machine& machine, const AxisValues& axes) {
  std::array<double, 2> angles{0, 0};
  const std::vector<RotaryAxis>& rotary = machine.kinematics.axes;
  for (std::size_t i = 0; i < std::min<std::size_t>(rotary.size(), 2); ++i)
    angles[i] = axes.at[static_cast<std::size_t>(rotary[i].letter - 'A') + 3];
  return PoseSolver(machine.kinematics).table(angles);
}

ToolPose PoseMaker::pose(const AxisValues& axes, ControlMode mode, double lengthened, double length,
                         const Placement& placement) const {
  AxisPose at{axes.xyz() - setup_.zero, {0, 0}};
  for (std::size_t i = 0; i < kinematics_.axes.size(); ++i) at.angles[i] = axes.at[rotary_[i]];
  const PoseSolver solver(mode == ControlMode::tip ? tip_kinematics_ : kinematics_);
  auto [tip, axis] = solver.pose(at, length);
  tip += lengthened * axis;
  return {placement.rotation * tip + placement.origin, placement.rotation * axis};
}

std::vector<AxisValues> PoseMaker::places(const AxisValues& from, const Motion& motion, double tolerance) const {
  std::vector<AxisValues> result{from};
  if (motion.kind == Motion::Kind::rapid && setup_.rapid_way == RapidWay::dog_leg) {
    // All axes move at the same speed, each until it arrives; one degree takes as long as one
    // millimetre.
    std::array<double, 9> way{};
    std::vector<double> stops;
    for (std::size_t a = 0; a < 9; ++a) {
      const bool turns = a >= 3 && a < 6;
      way[a] = std::abs(motion.end.at[a] - from.at[a]) * (turns ? degrees_per_radian : 1);
      if (way[a] > 0) stops.push_back(way[a]);
    }
    std::sort(stops.begin(), stops.end());
    for (const double stop : stops) {
      AxisValues at = from;
      for (std::size_t a = 0; a < 9; ++a)
        if (way[a] > 0) at.at[a] += (motion.end.at[a] - from.at[a]) * std::min(1.0, stop / way[a]);
      if (!(at == result.back())) result.push_back(at);
    }
  } else if (motion.kind == Motion::Kind::arc) {
    const std::size_t first = motion.plane == ArcPlane::xy ? 0 : motion.plane == ArcPlane::zx ? 2 : 1;
    const std::size_t second = (first + 1) % 3;
    const Vec2 start = Vec2(from.at[first], from.at[second]) - motion.centre;
    const Vec2 end = Vec2(motion.end.at[first], motion.end.at[second]) - motion.centre;
    double turn = std::atan2(start.x() * end.y() - start.y() * end.x(), start.dot(end));
    constexpr double full = 2 * std::numbers::pi;
    if (motion.turns > 0) {
      if (turn < 1e-9) turn += full;
      turn += full * (motion.turns - 1);
    } else {
      if (turn > -1e-9) turn -= full;
      turn -= full * (-motion.turns - 1);
    }
    const double radius = std::max(start.norm(), end.norm());
    const double step = radius > tolerance ? chord_angle(radius, tolerance) : full / 6;
    const int parts = std::clamp(static_cast<int>(std::ceil(std::abs(turn) / step)), 1, 100000);
    const double angle = std::atan2(start.y(), start.x());
    for (int i = 1; i < parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      AxisValues at = from;
      for (std::size_t a = 0; a < 9; ++a) at.at[a] += t * (motion.end.at[a] - from.at[a]);
      const double r = start.norm() + t * (end.norm() - start.norm());
      at.at[first] = motion.centre.x() + r * std::cos(angle + t * turn);
      at.at[second] = motion.centre.y() + r * std::sin(angle + t * turn);
      result.push_back(at);
    }
  }
  if (!(motion.end == result.back())) result.push_back(motion.end);
  return result;
}

std::vector<ToolPose> PoseMaker::along(const std::vector<AxisValues>& places, ControlMode mode, double lengthened,
                                       double length, const Placement& placement, double reach,
                                       double tolerance) const {
  std::vector<ToolPose> poses{pose(places.front(), mode, lengthened, length, placement)};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const auto between = [&](double t) {
      AxisValues at;
      for (std::size_t a = 0; a < 9; ++a) at.at[a] = places[i - 1].at[a] + t * (places[i].at[a] - places[i - 1].at[a]);
      return pose(at, mode, lengthened, length, placement);
    };
    const ToolPose end = between(1);
    bool turns = false;
    for (const std::size_t a : rotary_) turns |= a >= 3 && std::abs(places[i].at[a] - places[i - 1].at[a]) > 1e-12;
    if (!turns) {
      poses.push_back(end);
      continue;
    }
    // Bisection until midpoint and quarter points of each step agree with linear interpolation.
    const auto divide = [&](const auto& self, double t0, const ToolPose& a, double t1, const ToolPose& b,
                            int depth) -> void {
      bool even = true;
      for (const double share : {0.25, 0.5, 0.75}) {
        const ToolPose middle = between(t0 + share * (t1 - t0));
        const Vec3 tip = a.tip + share * (b.tip - a.tip), axis = (a.axis + share * (b.axis - a.axis)).normalized();
        even = even && (middle.tip - tip).norm() <= tolerance &&
               (middle.tip + reach * middle.axis - tip - reach * axis).norm() <= tolerance;
      }
      // The swept surface between two poses is ruled, so its sagitta counts as well.
      even = even && reach * (b.axis - a.axis).squaredNorm() / 8 <= tolerance;
      if (!even && depth < 14) {
        const double middle = 0.5 * (t0 + t1);
        const ToolPose m = between(middle);
        self(self, t0, a, middle, m, depth + 1);
        self(self, middle, m, t1, b, depth + 1);
        return;
      }
      poses.push_back(b);
    };
    const ToolPose start = poses.back();
    divide(divide, 0, start, 1, end, 0);
  }
  return poses;
}

}  // namespace fieldfab::cam
