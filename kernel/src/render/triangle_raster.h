/// Which pixels see which triangle: a z-buffer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster.h"

namespace fieldfab {

/// What each pixel sees.
struct SeenTriangles {
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<float> heights;            ///< -infinity where it sees nothing
  std::vector<std::uint32_t> triangles;  ///< or `none`
};

/// Casts a ray from above through each pixel's centre. `vertices` are in the picture's coordinates. A ray through a common edge
/// meets one of the two triangles at least; of triangles at one height the first counts.
SeenTriangles rasterise_triangles(std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                                  const PixelGrid& grid, Progress& progress);

/// Of a triangle's corners, how much each counts at a place of the picture; they add up to 1.
std::array<double, 3> shares_at(std::span<const Vec3> vertices, const std::array<std::uint32_t, 3>& triangle, double x, double y);

}  // namespace fieldfab
