#include "fieldfab/core/linear_maps.h"

#include <Eigen/SVD>

namespace fieldfab {

Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

Stretch stretch_of(const Eigen::Matrix3d& map) {
  const Vec3 values = map.jacobiSvd().singularValues();  // in decreasing order
  return {values[2], values[0]};
}

}  // namespace fieldfab
