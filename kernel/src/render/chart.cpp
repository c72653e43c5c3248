#include "fieldfab/render/chart.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldfab {

Image bar_chart(std::span<const std::uint64_t> counts, double mark, int width, int height) {
  Image image;
  image.width = width, image.height = height, image.channels = 3;
  image.pixels8.assign(static_cast<std::size_t>(3 * width * height), 255);
  const auto paint = [&](int x, int y, std::array<std::uint8_t, 3> colour) {
    std::copy(colour.begin(), colour.end(), image.pixels8.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + x));
  };
  // Each column shows the largest of its bins; bins wider than a column cover several.
  std::vector<double> tall(static_cast<std::size_t>(width));
  double tallest = 1;
  for (std::size_t x = 0; x < tall.size(); ++x) {
    const std::size_t first = x * counts.size() / tall.size(),
                      last = std::max(first + 1, (x + 1) * counts.size() / tall.size());
    for (std::size_t i = first; i < last && i < counts.size(); ++i)
      tall[x] = std::max(tall[x], std::log1p(static_cast<double>(counts[i])));
    tallest = std::max(tallest, tall[x]);
  }
  for (int x = 0; x < width; ++x) {
    const int top = height - static_cast<int>(std::lround((height - 8) * tall[static_cast<std::size_t>(x)] / tallest));
    for (int y = top; y < height; ++y) paint(x, y, {96, 112, 136});
  }
  const int line = std::clamp(static_cast<int>(mark * width), 1, width - 2);
  for (int y = 0; y < height; ++y)
    for (const int x : {line - 1, line}) paint(x, y, {208, 32, 32});
  return image;
}

}  // namespace fieldfab
