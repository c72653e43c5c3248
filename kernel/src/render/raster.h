/// Visibility of a solid by pixel, and its height: the part of rendering that evaluates the Field.
#pragma once

#include <vector>

#include <Eigen/Core>
#include "fieldfab/core/progress.h"

#include "fieldfab/field/field.h"

namespace fieldfab {

/// A grid of pixels over x and y of a region; row 0 is at the largest y.
struct PixelGrid {
  int width, height;
  Box region;

  /// Returns a grid whose longer side has `size` pixels. Throws bad_input for a region without
  /// extent or a size out of range.
  static PixelGrid over(const Box& region, int size);
  [[nodiscard]] float x(int column) const {
    return static_cast<float>(region.lower.x() + (column + 0.5) * region.size().x() / width);
  }
  [[nodiscard]] float y(int row) const {
    return static_cast<float>(region.upper.y() - (row + 0.5) * region.size().y() / height);
  }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

/// Sets each pixel whose centre in the plane z = region.lower.z is inside to 255; `pixels` must be
/// 0 before.
void rasterise_plane(const Field& field, const PixelGrid& grid, std::uint8_t* pixels, Progress& progress);

/// Unit vectors, one per pixel.
using Normals = std::vector<Eigen::Vector3f>;

/// Returns for each pixel the z at which a ray from above enters the solid, or -infinity. Thin
/// parts are found if they are at least about a pixel thick. A solid that the top of the region
/// cuts is met there. `normals`, if not null, gets the unit normals at those points (z if there is
/// none).
std::vector<float> rasterise_heights(const Field& field, const PixelGrid& grid, Normals* normals, Progress& progress);

}  // namespace fieldfab
