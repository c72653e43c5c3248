/// Conversion of heights, normals and light to pixels.
#pragma once

#include "fieldfab/render/image.h"
#include "raster.h"

namespace fieldfab {

/// Returns a black image with the size and position of the grid.
Image blank(const PixelGrid& grid, int channels, int depth);
/// Returns 16 bits: 0 for infinite heights, 1 .. 65535 from the bottom to the top of the grid's
/// region.
Image height_map(const PixelGrid& grid, const std::vector<float>& heights);
/// Returns x, y and z as red, green and blue, with 0 as middle grey; black for infinite heights.
Image normal_map(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals);
/// Averages samples x samples pixels into one, in linear light, and maps the result to the range of
/// a screen.
Image picture(const PixelGrid& grid, const std::vector<Eigen::Vector3f>& colours, int samples);

}  // namespace fieldfab
