#include "fieldfab/render/render.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "camera.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "shade.h"
#include "to_image.h"

namespace fieldfab {
namespace {

Image bitmap(const Field& field, const PixelGrid& grid, Progress& progress) {
  Image image = blank(grid, 1, 8);
  rasterise_plane(field, grid, image.pixels8.data(), progress);
  return image;
}

/// Converts an sRGB channel to linear light, 0 to 1.
float linear(std::uint8_t number) {
  const float share = static_cast<float>(number) / 255;
  return share <= 0.04045F ? share / 12.92F : std::pow((share + 0.055F) / 1.055F, 2.4F);
}

/// Returns the colour of each pixel that sees a part: that of the part with the least value at the
/// point.
std::vector<Eigen::Vector3f> materials_of(std::span<const ColouredPart> parts, const Box& bounds,
                                          const RenderSettings& settings, const PixelGrid& grid,
                                          const std::vector<float>& heights, Progress& progress) {
  std::vector<FieldPtr> fields;
  std::vector<Eigen::Vector3f> colours;
  for (const ColouredPart& part : parts) {
    fields.push_back(look(*part.field, bounds, settings).field);
    colours.push_back(
        part.colour ? Eigen::Vector3f(linear(part.colour->red), linear(part.colour->green), linear(part.colour->blue))
                    : plain_material);
  }
  std::vector<Eigen::Vector3f> materials(grid.count(), plain_material);
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t row) {
    progress.check();
    std::vector<std::size_t> seen;
    std::vector<float> x, y, z;
    for (int column = 0; column < grid.width; ++column) {
      const std::size_t i = grid.index(column, static_cast<int>(row));
      if (!std::isfinite(heights[i])) continue;
      seen.push_back(i);
      x.push_back(grid.x(column)), y.push_back(grid.y(static_cast<int>(row))), z.push_back(heights[i]);
    }
    std::vector<float> least(seen.size(), std::numeric_limits<float>::infinity()), value(seen.size());
    for (std::size_t part = 0; part < fields.size(); ++part) {
      fields[part]->values({x.data(), y.data(), z.data(), x.size()}, value.data());
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (value[i] < least[i]) least[i] = value[i], materials[seen[i]] = colours[part];
    }
  });
  return materials;
}

}  // namespace

RenderMode render_mode(std::string_view name) {
  if (name == "bitmap") return RenderMode::bitmap;
  if (name == "height") return RenderMode::height;
  if (name == "normals") return RenderMode::normals;
  if (name == "shaded") return RenderMode::shaded;
  throw Error(ErrorKind::bad_input, "mode", "'" + std::string(name) + "' is none of bitmap, height, normals, shaded");
}

Image render(const Field& field, const Box& bounds, const RenderSettings& settings, Progress& progress,
             std::span<const ColouredPart> parts) {
  if (settings.mode == RenderMode::bitmap) {
    Box plane = bounds;
    if (settings.window)
      plane.lower.head<2>() = settings.window->lower.head<2>(),
      plane.upper.head<2>() = settings.window->upper.head<2>();
    return bitmap(field, PixelGrid::over(plane, settings.size), progress);
  }
  if (settings.samples < 1 || settings.samples > 4)
    throw Error(ErrorKind::bad_input, "samples",
                std::to_string(settings.samples) + " samples; from 1 to 4 are possible");
  const View view = look(field, bounds, settings);
  const int samples = settings.mode == RenderMode::shaded ? settings.samples : 1;
  PixelGrid grid = PixelGrid::over(view.region, settings.size);
  grid.width *= samples, grid.height *= samples;
  Normals normals;
  const bool only_heights = settings.mode == RenderMode::height;
  const std::vector<float> heights = rasterise_heights(*view.field, grid, only_heights ? nullptr : &normals, progress);
  if (only_heights) return height_map(grid, heights);
  straighten(view, grid, heights, normals);
  if (settings.mode == RenderMode::normals) return normal_map(grid, heights, normals);
  std::vector<Eigen::Vector3f> materials;
  if (std::any_of(parts.begin(), parts.end(), [](const ColouredPart& part) { return part.colour.has_value(); }))
    materials = materials_of(parts, bounds, settings, grid, heights, progress);
  return picture(grid, shade(grid, heights, normals, materials, progress), samples);
}

}  // namespace fieldfab
