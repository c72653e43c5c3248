#include "fieldfab/render/render.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "raster.h"

namespace fieldfab {
namespace {

/// The turn of App. C: alpha about z, then beta about x.
Eigen::Affine3d turn(const RenderSettings& settings) {
  return Eigen::Affine3d(Eigen::AngleAxisd(settings.beta, Vec3::UnitX()) * Eigen::AngleAxisd(settings.alpha, Vec3::UnitZ()));
}

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

/// How open the sky is above each pixel, 0 to 1: horizons in eight directions, read off the height map at growing distances.
std::vector<float> find_openness(const PixelGrid& grid, const std::vector<float>& heights, Progress& progress) {
  std::vector<float> openness(grid.count(), 1);
  const float pixel = static_cast<float>(grid.region.size().x() / grid.width);
  const int reach = std::max(4, std::max(grid.width, grid.height) / 12);
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    progress.check();
    const int y = static_cast<int>(row);
    for (int x = 0; x < grid.width; ++x) {
      const float here = heights[grid.index(x, y)];
      if (!std::isfinite(here)) continue;
      float sum = 0;
      constexpr int directions = 12;
      for (int d = 0; d < directions; ++d) {
        const float angle = 6.2831853F * (static_cast<float>(d) + 0.25F) / directions;
        const float cx = std::cos(angle), cy = std::sin(angle);
        float steepest = 0;
        for (float distance = 1.5F; distance < static_cast<float>(reach); distance *= 1.5F) {
          const int u = x + static_cast<int>(std::lround(cx * distance)), v = y + static_cast<int>(std::lround(cy * distance));
          if (u < 0 || v < 0 || u >= grid.width || v >= grid.height) break;
          const float rise = (heights[grid.index(u, v)] - here) / (distance * pixel);
          steepest = std::max(steepest, rise * (1 - distance / static_cast<float>(reach)));
        }
        sum += 1 - steepest / std::sqrt(1 + steepest * steepest);
      }
      openness[grid.index(x, y)] = sum / directions;
    }
  });
  return openness;
}

Image bitmap(const Field& field, const PixelGrid& grid, Progress& progress) {
  Image image = blank(grid, 1, 8);
  rasterise_plane(field, grid, image.pixels8.data(), progress);
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

Image shaded(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals,
             const std::vector<float>& openness) {
  const Eigen::Vector3f key = Eigen::Vector3f(-0.45F, 0.55F, 0.75F).normalized(),
                        fill = Eigen::Vector3f(0.7F, -0.2F, 0.45F).normalized();
  const Eigen::Vector3f material(0.80F, 0.83F, 0.88F), warm(1.0F, 0.96F, 0.90F), cool(0.62F, 0.74F, 1.0F),
      sky(0.78F, 0.86F, 1.0F);
  Image image = blank(grid, 3, 8);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const std::size_t i = grid.index(x, y);
      Eigen::Vector3f colour;
      if (std::isfinite(heights[i])) {
        const Eigen::Vector3f& n = normals[i];
        const float open = openness[i];
        const float shine = std::pow(std::max(0.0F, (2 * n.dot(key) * n - key).z()), 24.0F);
        colour = material.cwiseProduct(0.28F * open * (0.6F + 0.4F * n.z()) * sky +
                                       0.72F * (0.35F + 0.65F * open) * std::max(0.0F, n.dot(key)) * warm +
                                       0.22F * std::max(0.0F, n.dot(fill)) * cool);
        colour += Eigen::Vector3f::Constant(0.18F * shine * open);
      } else {
        const float down = static_cast<float>(y) / static_cast<float>(grid.height);
        colour = (1 - down) * Eigen::Vector3f(0.955F, 0.965F, 0.98F) + down * Eigen::Vector3f(0.82F, 0.85F, 0.89F);
        colour = colour.cwiseProduct(colour);
      }
      for (int c = 0; c < 3; ++c)
        image.pixels8[3 * i + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(colour[c], 0.0F, 1.0F))));
    }
  return image;
}

}  // namespace

RenderMode render_mode(std::string_view name) {
  if (name == "bitmap") return RenderMode::bitmap;
  if (name == "height") return RenderMode::height;
  if (name == "normals") return RenderMode::normals;
  if (name == "shaded") return RenderMode::shaded;
  throw Error(ErrorKind::bad_input, "mode", "'" + std::string(name) + "' is none of bitmap, height, normals, shaded");
}

Image render(const Field& field, const Box& bounds, const RenderSettings& settings, Progress& progress) {
  if (settings.mode == RenderMode::bitmap) return bitmap(field, PixelGrid::over(bounds, settings.size), progress);
  if (!bounds.valid() || bounds.size().minCoeff() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a picture of a solid needs finite bounds with a positive size along x, y and z");
  if (!std::isfinite(settings.alpha) || !std::isfinite(settings.beta))
    throw Error(ErrorKind::bad_input, "angle", "must be a finite number");

  FieldPtr seen = field.shared_from_this();
  Box region = bounds;
  if (settings.alpha != 0 || settings.beta != 0) {
    const Eigen::Affine3d turned = turn(settings);
    seen = transform(intersect(seen, box_field(bounds)), turned);
    region = image_of(bounds, turned.linear(), turned.translation());
  }
  const PixelGrid grid = PixelGrid::over(region, settings.size);
  Normals normals;
  const bool only_heights = settings.mode == RenderMode::height;
  const std::vector<float> heights = rasterise_heights(*seen, grid, only_heights ? nullptr : &normals, progress);
  if (only_heights) return height_map(grid, heights);
  if (settings.mode == RenderMode::normals) return normal_map(grid, heights, normals);
  return shaded(grid, heights, normals, find_openness(grid, heights, progress));
}

}  // namespace fieldfab
