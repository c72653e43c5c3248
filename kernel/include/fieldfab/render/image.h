/// Pixels, and PNG files with their physical size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/geometry.h"

namespace fieldfab {

/// An image of 1 or 3 channels with 8 or 16 bits (Keeter App. C: koko.fab.image.Image). Rows from the top (largest y) down.
struct Image {
  int width = 0, height = 0, channels = 1, depth = 8;
  std::vector<std::uint8_t> pixels8;    ///< where depth is 8: width * height * channels
  std::vector<std::uint16_t> pixels16;  ///< where depth is 16
  double pixels_per_mm = 0;             ///< 0: not known
  Box bounds;                           ///< the region shown, mm; x and y give the size, z the heights of a height map
  bool has_heights = false;             ///< write and read bounds' z as the text chunks zmin and zmax
};

/// PNG with pHYs, and for height maps tEXt chunks `zmin` and `zmax` in mm. Throws io. Whole or not at all.
void write_png(const Image& image, const std::filesystem::path& path);
/// The same in memory; `name` is for messages.
std::string png_bytes(const Image& image, const std::string& name = "image");
/// Reads grey, RGB or palette PNGs of any depth. Throws io, bad_input.
Image read_png(const std::filesystem::path& path);

}  // namespace fieldfab
