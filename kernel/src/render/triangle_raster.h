/// Visibility of triangles by pixel: a z-buffer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster.h"

namespace fieldfab {

/// Visible triangle of each pixel.
struct SeenTriangles {
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<float> heights;            ///< -infinity if no triangle is visible
  std::vector<std::uint32_t> triangles;  ///< index, or `none`
};

/// Casts a ray from above through the centre of each pixel. `vertices` are in the coordinates of
/// the image. A ray through a common edge meets at least one of the two triangles; of triangles at
/// the same height the first counts.
SeenTriangles rasterise_triangles(std::span<const Vec3> vertices,
                                  std::span<const std::array<std::uint32_t, 3>> triangles, const PixelGrid& grid,
                                  Progress& progress);

/// Returns the barycentric weights of a triangle's corners at a point of the image; they add up to
/// 1.
std::array<double, 3> shares_at(std::span<const Vec3> vertices, const std::array<std::uint32_t, 3>& triangle, double x,
                                double y);

}  // namespace fieldfab
