/// Plane geometry for path planning: points, rectangles, lattices of samples, closed curves.
#pragma once

#include <cstdint>
#include <vector>

#include "fieldfab/cam/base/units.h"
#include "fieldfab/core/geometry.h"

namespace fieldfab::cam {

/// A closed rectangle, mm.
struct Rectangle {
  Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
  [[nodiscard]] Vec2 size() const { return upper - lower; }
  [[nodiscard]] Rectangle grown(double margin) const { return {lower.array() - margin, upper.array() + margin}; }
  [[nodiscard]] bool contains(const Vec2& p) const {
    return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
  }
  [[nodiscard]] bool contains(const Rectangle& other) const { return contains(other.lower) && contains(other.upper); }
  void add(const Vec2& p) { lower = lower.cwiseMin(p), upper = upper.cwiseMax(p); }
  /// Returns the empty rectangle, the neutral element of add().
  static Rectangle nothing() { return {Vec2::Constant(1e300), Vec2::Constant(-1e300)}; }
  /// Returns the projection of a box.
  static Rectangle of(const Box& box) { return {box.lower.head<2>(), box.upper.head<2>()}; }
  [[nodiscard]] Box at(double z) const { return {{lower.x(), lower.y(), z}, {upper.x(), upper.y(), z}}; }
};

/// Equally spaced samples along x and y; row 0 has the least y.
template <class Sample>
struct Lattice {
  int width = 0, height = 0;
  double cell = 1;             ///< spacing, mm
  Vec2 origin = Vec2::Zero();  ///< position of sample (0, 0), mm
  std::vector<Sample> values;

  Lattice() = default;
  Lattice(int columns, int rows, double step, const Vec2& first, Sample fill)
      : width(columns),
        height(rows),
        cell(step),
        origin(first),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] Sample at(int column, int row) const { return values[index(column, row)]; }
  Sample& at(int column, int row) { return values[index(column, row)]; }
  [[nodiscard]] const Sample* row(int r) const { return values.data() + index(0, r); }
  Sample* row(int r) { return values.data() + index(0, r); }
  [[nodiscard]] Vec2 place(double column, double row) const { return origin + cell * Vec2(column, row); }
  /// Rectangle from the first sample to the last, mm.
  [[nodiscard]] Rectangle extent() const { return {origin, place(width - 1, height - 1)}; }
};

/// Bitmap: solid samples are not 0.
using Bitmap = Lattice<std::uint8_t>;
/// Height map, mm; minus infinity for no material.
using HeightMap = Lattice<float>;

/// A closed curve with the solid on its left: counter-clockwise around a solid, clockwise around a hole. Points are mm.
struct Loop {
  std::vector<Vec2> points;
  [[nodiscard]] double area() const;    ///< signed area, mm^2: positive around a solid
  [[nodiscard]] double length() const;  ///< length, mm
  [[nodiscard]] Rectangle bounds() const;
  /// Whether the loop encloses the point (even-odd rule). O(points).
  [[nodiscard]] bool encloses(const Vec2& p) const;
};
using Loops = std::vector<Loop>;

/// Returns, for each loop, the index of the smallest enclosing loop, or -1. Loops must not cross. O(n log n) for
/// typical CAM data.
std::vector<int> nesting(const Loops& loops);

}  // namespace fieldfab::cam
