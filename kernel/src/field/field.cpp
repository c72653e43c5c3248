#include "fieldfab/field/field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldfab {

void Field::restrict_all(std::span<const Box> boxes, Purpose /*purpose*/, std::span<Restriction> out) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) out[i] = {interval(boxes[i]), *this};
}

void Field::slopes(const Box& /*box*/, std::span<const Vec3> directions, std::span<Interval> out) const noexcept {
  std::fill_n(out.begin(), directions.size(), Interval::unknown());
}

bool Field::facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept {
  // A difference is a weighted sum of differences along the axes, so no corner of the box of slopes
  // is left out.
  const std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  std::array<Interval, 3> slope;
  slopes(box, axes, slope);
  for (const Interval& along : slope)
    if (along.maybe_nan || std::isinf(along.lower) || std::isinf(along.upper)) return false;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Eigen::Vector3f direction;
    for (unsigned axis = 0; axis < 3; ++axis)
      direction[axis] = (corner >> axis & 1U) != 0 ? slope[axis].upper : slope[axis].lower;
    if (direction.isZero(0)) return false;
    directions.push_back(direction.normalized());
  }
  return true;
}

Restriction Field::restricted(const Box& box, Purpose purpose) const {
  Restriction result;
  restrict_all({&box, 1}, purpose, {&result, 1});
  return result;
}

Framed Field::framed(Purpose /*purpose*/) const {
  return {shared_from_this(), Eigen::Matrix3d::Identity(), Vec3::Zero()};
}

float Field::value(const Vec3& point) const noexcept {
  const Eigen::Vector3f p = point.cast<float>();
  float out = 0;
  values({&p.x(), &p.y(), &p.z(), 1}, &out);
  return out;
}

Vec3 Field::gradient(const Vec3& point) const noexcept {
  const Eigen::Vector3f p = point.cast<float>();
  Eigen::Vector3f slope;
  float out = 0;
  gradients({&p.x(), &p.y(), &p.z(), 1}, &out, {&slope.x(), &slope.y(), &slope.z()});
  return slope.cast<double>();
}

}  // namespace fieldfab
