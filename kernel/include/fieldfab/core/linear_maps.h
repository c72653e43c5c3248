/// Turns and stretches of linear maps, by Eigen's singular values. Compiled once: each file that called Eigen itself
/// would compile its decompositions anew, which takes seconds.
#pragma once

#include <Eigen/Geometry>

#include "fieldfab/core/geometry.h"

namespace fieldfab {

/// Returns the smallest turn that takes the direction of `from` to that of `to`. Neither may be 0.
Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to);

/// Smallest and greatest factor by which a linear map changes lengths.
struct Stretch {
  double least, greatest;
  /// Whether the map changes all lengths alike, to 1 part in 10,000.
  [[nodiscard]] bool is_even() const { return greatest - least < 1e-4 * greatest; }
};
Stretch stretch_of(const Eigen::Matrix3d& map);

}  // namespace fieldfab
