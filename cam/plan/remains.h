/// Material on a lattice, for clearing with constant engagement.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/distance.h"

namespace fieldfab::cam {

/// Remaining area to cut, as covered fractions of a lattice's cells. Cells on the edge of a cut are
/// partly covered, so that areas are much more accurate than the cell size.
class Remains {
 public:
  Remains(const Rectangle& region, double cell, double radius)
      : radius_(radius),
        share_(static_cast<int>(std::ceil(region.size().x() / cell)) + 1,
               static_cast<int>(std::ceil(region.size().y() / cell)) + 1, cell, region.lower, 0) {}

  [[nodiscard]] Bitmap& cells() { return share_; }
  [[nodiscard]] const Bitmap& cells() const { return share_; }

  /// Area that the tool cuts in a step, mm^2, if all material under it at `from` is already cut.
  [[nodiscard]] double cut_area(const Vec2& from, const Vec2& to) const {
    double sum = 0;
    each_row(to, [&](int row, double left, double right) {
      const double old = half_width(from, row), middle = column(from.x());
      if (old <= 0) return void(sum += in_row(row, left, right));
      // The remaining part of a cell on an edge lies beyond the edge.
      if (left < middle - old) sum += in_row(row, left, std::min(right, std::floor(middle - old) + 1));
      if (right > middle + old) sum += in_row(row, std::max(left, std::floor(middle + old)), right);
    });
    return sum * share_.cell * share_.cell / full;
  }
  [[nodiscard]] double covered_area(const Vec2& at) const {
    double sum = 0;
    each_row(at, [&](int row, double left, double right) { sum += in_row(row, left, right); });
    return sum * share_.cell * share_.cell / full;
  }

  /// Removes the area under the tool at a point.
  void cut(const Vec2& at) {
    each_row(at, [&](int row, double left, double right) {
      std::uint8_t* const cells = share_.row(row);
      const int first = static_cast<int>(std::floor(left)), last = static_cast<int>(std::ceil(right)) - 1;
      const auto keep = [&](int c, double part) {
        if (c >= 0 && c < share_.width)
          cells[c] = std::min(cells[c], static_cast<std::uint8_t>(std::ceil(full * part)));
      };
      if (last <= first) return keep(first, (left - first) + (first + 1 - right));
      keep(first, left - first), keep(last, last + 1 - right);
      for (int c = std::max(0, first + 1); c < std::min(last, share_.width); ++c) cells[c] = 0;
    });
  }
  /// Removes the area along a straight line, in steps so short that ridges at the sides are
  /// negligible.
  void cut(const Vec2& from, const Vec2& to) {
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / (0.1 * radius_))));
    for (int i = 1; i <= steps; ++i) cut(Vec2(from + (to - from) * i / steps));
  }

  [[nodiscard]] bool any(const Vec2& p) const {
    const int c = static_cast<int>(std::floor(column(p.x()))),
              r = static_cast<int>(std::lround((p.y() - share_.origin.y()) / share_.cell));
    return c >= 0 && r >= 0 && c < share_.width && r < share_.height && share_.at(c, r) > full / 2;
  }
  [[nodiscard]] double area() const {
    double sum = 0;
    for (const std::uint8_t share : share_.values) sum += share;
    return sum * share_.cell * share_.cell / full;
  }

  static constexpr int full = 255;

 private:
  /// x in cells: cell c is the interval [c, c + 1].
  [[nodiscard]] double column(double x) const { return (x - share_.origin.x()) / share_.cell + 0.5; }
  /// Half width of the disc in a row, in cells.
  [[nodiscard]] double half_width(const Vec2& at, int row) const {
    const double up = share_.origin.y() + row * share_.cell - at.y(), squared = radius_ * radius_ - up * up;
    return squared > 0 ? std::sqrt(squared) / share_.cell : 0;
  }
  template <class Visit>
  void each_row(const Vec2& at, const Visit& visit) const {
    const double middle = (at.y() - share_.origin.y()) / share_.cell, reach = radius_ / share_.cell;
    const int first = std::max(0, static_cast<int>(std::ceil(middle - reach))),
              last = std::min(share_.height - 1, static_cast<int>(std::floor(middle + reach)));
    for (int row = first; row <= last; ++row) {
      const double half = half_width(at, row), x = column(at.x());
      if (half > 0) visit(row, x - half, x + half);
    }
  }
  /// Area that a cut between two columns removes, consistent with cut().
  [[nodiscard]] double in_row(int row, double left, double right) const {
    const std::uint8_t* const cells = share_.row(row);
    const int first = static_cast<int>(std::floor(left)), last = static_cast<int>(std::ceil(right)) - 1;
    const auto taken = [&](int c, double kept) {
      return c < 0 || c >= share_.width ? 0.0 : std::max(0.0, cells[c] - std::ceil(full * kept));
    };
    if (last <= first) return taken(first, (left - first) + (first + 1 - right));
    double sum = taken(first, left - first) + taken(last, last + 1 - right);
    for (int c = std::max(0, first + 1); c < std::min(last, share_.width); ++c) sum += cells[c];
    return sum;
  }

  double radius_;
  Bitmap share_;
};

/// Marks the cells of a lattice whose centres are within loops, by the even-odd rule.
void mark_inside(const Loops& loops, Bitmap& cells);

}  // namespace fieldfab::cam
