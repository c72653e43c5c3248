#include "to_image.h"

#include <algorithm>
#include <cmath>

namespace fieldfab {

Image blank(const PixelGrid& grid, int channels, int depth) {
  Image image;
  image.width = grid.width;
  image.height = grid.height;
  image.channels = channels;
  image.depth = depth;
  const std::size_t samples = grid.count() * static_cast<std::size_t>(channels);
  if (depth == 16)
    image.pixels16.resize(samples);
  else
    image.pixels8.resize(samples);
  image.pixels_per_mm = grid.width / grid.region.size().x();
  image.bounds = grid.region;
  return image;
}

Image height_map(const PixelGrid& grid, const std::vector<float>& heights) {
  Image image = blank(grid, 1, 16);
  image.has_heights = true;
  const double low = grid.region.lower.z(), range = grid.region.size().z();
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (std::isfinite(heights[i]))
      image.pixels16[i] = static_cast<std::uint16_t>(std::clamp(1 + (heights[i] - low) / range * 65534, 1.0, 65535.0));
  return image;
}

Image normal_map(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals) {
  Image image = blank(grid, 3, 8);
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (std::isfinite(heights[i]))
      for (int c = 0; c < 3; ++c)
        image.pixels8[3 * i + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(127.5F + 127.5F * normals[i][c]));
  return image;
}

Image picture(const PixelGrid& grid, const std::vector<Eigen::Vector3f>& colours, int samples) {
  const PixelGrid small{grid.width / samples, grid.height / samples, grid.region};
  Image image = blank(small, 3, 8);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int v = 0; v < samples; ++v)
        for (int u = 0; u < samples; ++u) sum += colours[grid.index(x * samples + u, y * samples + v)];
      sum /= static_cast<float>(samples * samples);
      for (int c = 0; c < 3; ++c)
        image.pixels8[3 * small.index(x, y) + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(sum[c], 0.0F, 1.0F))));
    }
  return image;
}

}  // namespace fieldfab
