#include "fieldfab/render/render.h"

#include <string>

#include "camera.h"
#include "fieldfab/core/error.h"
#include "shade.h"
#include "to_image.h"

namespace fieldfab {
namespace {

Image bitmap(const Field& field, const PixelGrid& grid, Progress& progress) {
  Image image = blank(grid, 1, 8);
  rasterise_plane(field, grid, image.pixels8.data(), progress);
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
  if (settings.mode == RenderMode::bitmap) {
    Box plane = bounds;
    if (settings.window)
      plane.lower.head<2>() = settings.window->lower.head<2>(), plane.upper.head<2>() = settings.window->upper.head<2>();
    return bitmap(field, PixelGrid::over(plane, settings.size), progress);
  }
  if (settings.samples < 1 || settings.samples > 4)
    throw Error(ErrorKind::bad_input, "samples", std::to_string(settings.samples) + " samples; from 1 to 4 are possible");
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
  return picture(grid, shade(grid, heights, normals, {}, progress), samples);
}

}  // namespace fieldfab
