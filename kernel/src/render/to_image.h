/// From heights, normals and light to the pixels of an image.
#pragma once

#include "fieldfab/render/image.h"
#include "raster.h"

namespace fieldfab {

/// An image of the grid's size and place, black.
Image blank(const PixelGrid& grid, int channels, int depth);
/// 16 bits: 0 where heights are infinite, 1 .. 65535 from the bottom to the top of the grid's region.
Image height_map(const PixelGrid& grid, const std::vector<float>& heights);
/// x, y and z as red, green and blue, the middle grey is 0; black where heights are infinite.
Image normal_map(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals);
/// Averages samples x samples pixels into one, as light, and brings it into the range of a screen.
Image picture(const PixelGrid& grid, const std::vector<Eigen::Vector3f>& colours, int samples);

}  // namespace fieldfab
