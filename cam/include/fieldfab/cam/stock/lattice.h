/// The sampling lattice of simulated stock (Hahn 4.1).
#pragma once

#include <algorithm>
#include <array>

#include "fieldfab/core/geometry.h"

namespace fieldfab::cam {

using Index3 = std::array<int, 3>;

/// Equally spaced points in a box; the outermost ones are on its faces.
class StockLattice {
 public:
  StockLattice() = default;
  /// Divides each side into the number of cells nearest to `cell` mm, along z to `height` mm if that is larger. Throws
  /// Error(bad_input) for an empty box or a cell that is not positive, Error(too_large) for more than 2^21 cells along
  /// an axis.
  StockLattice(const Box& box, double cell, double height = 0);

  [[nodiscard]] const Box& box() const { return box_; }
  /// Number of cells along each axis; there is one more point than cells.
  [[nodiscard]] const Index3& cells() const { return cells_; }
  [[nodiscard]] const Vec3& spacing() const { return spacing_; }
  /// Position of point `k` along an axis, mm from the box's lower corner, rounded to float as in comparisons with
  /// samples.
  [[nodiscard]] float at(int axis, int k) const { return static_cast<float>(spacing_[axis] * k); }
  /// Returns the index of the first point above a coordinate; it may lie outside the box.
  [[nodiscard]] int above(int axis, float coordinate) const {
    int k = guess(axis, coordinate);
    while (at(axis, k) <= coordinate && k < most) ++k;
    while (at(axis, k - 1) > coordinate && k > -most) --k;
    return k;
  }
  /// Returns the index of the last point below a coordinate; it may lie outside the box.
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
