#include "fieldfab/field/field.h"

#include <algorithm>

namespace fieldfab {

void Field::restrict_all(std::span<const Box> boxes, Purpose /*purpose*/, std::span<Restriction> out) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) out[i] = {interval(boxes[i]), shared_from_this()};
}

void Field::slopes(const Box& /*box*/, std::span<const Vec3> directions, std::span<Interval> out) const noexcept {
  std::fill_n(out.begin(), directions.size(), Interval::unknown());
}

Restriction Field::restricted(const Box& box, Purpose purpose) const {
  Restriction result;
  restrict_all({&box, 1}, purpose, {&result, 1});
  return result;
}

Framed Field::framed(Purpose /*purpose*/) const { return {shared_from_this(), Eigen::Matrix3d::Identity(), Vec3::Zero()}; }

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
