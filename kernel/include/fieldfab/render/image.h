/// Images, and PNG files with physical size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fieldfab/core/geometry.h"

namespace fieldfab {

/// An image of 1 or 3 channels with 8 or 16 bits per sample (Keeter Appendix C: koko.fab.image.Image). Rows are stored
/// from the top (largest y) to the bottom.
struct Image {
  int width = 0, height = 0, channels = 1, depth = 8;
  std::vector<std::uint8_t> pixels8;    ///< samples if depth is 8: width * height * channels
  std::vector<std::uint16_t> pixels16;  ///< samples if depth is 16, alike
  double pixels_per_mm = 0;             ///< resolution; 0: unknown
  Box bounds;                           ///< region shown, mm: x and y give the size, z the range of a height map
  /// whether z of `bounds` is written to, or was read from, the text chunks zmin and zmax
  bool has_heights = false;
};

/// Writes a PNG file with the resolution (pHYs), and for height maps with text chunks `zmin` and `zmax` in mm. Written
/// completely or not at all. Throws Error(io).
void write_png(const Image& image, const std::filesystem::path& path);
/// Returns the bytes of the PNG file; `name` appears in messages.
std::string png_bytes(const Image& image, const std::string& name = "image");
/// Reads a grey, RGB or palette PNG of any depth. Throws Error(io), Error(bad_input).
Image read_png(const std::filesystem::path& path);

}  // namespace fieldfab
