#include "drawing.h"

#include <algorithm>
#include <cmath>

#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab::cam {

namespace s = frep::shapes;

void paint(Image& image, const frep::Expression& shape, const Box& where, const Colour& colour, double opacity) {
  const int left = std::max(0, static_cast<int>(std::floor(where.lower.x())) - 1),
            right = std::min(image.width, static_cast<int>(std::ceil(where.upper.x())) + 1),
            bottom = std::max(0, static_cast<int>(std::floor(where.lower.y())) - 1),
            top = std::min(image.height, static_cast<int>(std::ceil(where.upper.y())) + 1);
  if (left >= right || bottom >= top) return;
  const FieldPtr field = frep::make_field(shape);
  const auto count = static_cast<std::size_t>(right - left);
  std::vector<float> x(count), y(count), z(count, 0), distance(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = static_cast<float>(left) + static_cast<float>(i) + 0.5F;
  for (int row = bottom; row < top; ++row) {
    std::fill(y.begin(), y.end(), static_cast<float>(row) + 0.5F);
    field->values({x.data(), y.data(), z.data(), count}, distance.data());
    std::uint8_t* const pixels = image.pixels8.data() + 3 * (static_cast<std::size_t>(image.height - 1 - row) *
                                                                 static_cast<std::size_t>(image.width) +
                                                             static_cast<std::size_t>(left));
    for (std::size_t i = 0; i < count; ++i) {
      const double cover = opacity * std::clamp(0.5 - static_cast<double>(distance[i]), 0.0, 1.0);
      for (std::size_t c = 0; c < 3; ++c)
        pixels[3 * i + c] =
            static_cast<std::uint8_t>(std::lround(pixels[3 * i + c] + cover * (colour[c] - pixels[3 * i + c])));
    }
  }
}

void paint_words(Image& image, const std::string& words, double x, double y, double height, const Colour& colour,
                 double opacity) {
  const frep::Expression text = s::text(words, height, 0.17 * height);
  // The width of a letter is two thirds of its height, the gap one third.
  const double width = height * (static_cast<double>(words.size()) - 1.0 / 3);
  paint(image, s::move(text, x - width / 2, y - height / 2, 0.0),
        {{x - width / 2 - height, y - height, 0}, {x + width / 2 + height, y + height, 0}}, colour, opacity);
}

}  // namespace fieldfab::cam
