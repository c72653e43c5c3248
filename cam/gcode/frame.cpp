#include "frame.h"

#include <cmath>

#include "fieldfab/core/angle.h"

namespace fieldfab::cam::gcode {
namespace {

void turn(double& first, double& second, double angle) {
  if (angle == 0) return;
  const double c = std::cos(to_radians(angle)), s = std::sin(to_radians(angle)), x = first;
  first = c * x - s * second;
  second = s * x + c * second;
}

void turn(AxisValues& values, const Turned& turned, double sign) {
  const PlaneAxes axes = axes_of(turned.plane);
  double& first = values.at[axes.first];
  double& second = values.at[axes.second];
  first -= turned.about.x(), second -= turned.about.y();
  turn(first, second, sign * turned.angle);
  first += turned.about.x(), second += turned.about.y();
}

}  // namespace

AxisValues Frame::added(const AxisValues& a, const AxisValues& b, double sign) {
  AxisValues sum;
  for (std::size_t k = 0; k < sum.at.size(); ++k) sum.at[k] = a.at[k] + sign * b.at[k];
  return sum;
}

AxisValues Frame::tip(const AxisValues& program) const {
  AxisValues values = program;
  if (turned) turn(values, *turned, 1);
  values = added(values, axis_offset, 1);
  turn(values.at[0], values.at[1], rotation);
  return added(values, origin, 1);
}

AxisValues Frame::of_tip(const AxisValues& tip) const {
  AxisValues values = added(tip, origin, -1);
  turn(values.at[0], values.at[1], -rotation);
  values = added(values, axis_offset, -1);
  if (turned) turn(values, *turned, -1);
  return values;
}

}  // namespace fieldfab::cam::gcode
