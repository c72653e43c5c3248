/// The sampling grid of simulated stock (Hahn 4.1).
#pragma once

#include <algorithm>
#include <array>

#include "fieldfab/core/geometry.h"

namespace fieldfab::cam {

using Index3 = std::array<int, 3>;

/// Points at equal distances in a box, the outermost ones on its faces.
class StockLattice {
 public:
  StockLattice() = default;
  /// As many cells along each axis as make them nearest to `cell` mm, along z to `height` where that is more. Throws bad_input
  /// for an empty box or a cell that is not positive, too_large for more than 2^21 cells along an axis.
  StockLattice(const Box& box, double cell, double height = 0);

  [[nodiscard]] const Box& box() const { return box_; }
  /// Cells along each axis; points are one more.
  [[nodiscard]] const Index3& cells() const { return cells_; }
  [[nodiscard]] const Vec3& spacing() const { return spacing_; }
  /// Where a point lies along an axis, mm from the box's lower corner, as samples are compared with it.
  [[nodiscard]] float at(int axis, int k) const { return static_cast<float>(spacing_[axis] * k); }
  /// The first point above a coordinate, of all integers.
  [[nodiscard]] int above(int axis, float coordinate) const {
    int k = guess(axis, coordinate);
    while (at(axis, k) <= coordinate && k < most) ++k;
    while (at(axis, k - 1) > coordinate && k > -most) --k;
    return k;
  }
  /// The last point below a coordinate, of all integers.
  [[nodiscard]] int below(int axis, float coordinate) const {
    int k = guess(axis, coordinate);
    while (at(axis, k) >= coordinate && k > -most) --k;
    while (at(axis, k + 1) < coordinate && k < most) ++k;
    return k;
  }

 private:
  static constexpr int most = 100'000'000;
  [[nodiscard]] int guess(int axis, float coordinate) const {
    return static_cast<int>(std::clamp(coordinate * inverse_[axis], -1e8, 1e8));
  }
  Box box_;
  Index3 cells_{1, 1, 1};
  Vec3 spacing_ = Vec3::Ones(), inverse_ = Vec3::Ones();
};

}  // namespace fieldfab::cam
