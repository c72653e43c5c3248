/// Flat shapes painted over rendered pictures: marks, numbers, legends.
#pragma once

#include "fieldfab/frep/expression.h"
#include "fieldfab/render/triangles.h"

namespace fieldfab::cam {

/// Paints the part of a flat shape in a rectangle, both in pixels from the picture's lower left
/// corner, y up. Edges are antialiased if the shape is an exact distance. `opacity` from 0 to 1.
void paint(Image& image, const frep::Expression& shape, const Box& where, const Colour& colour, double opacity = 1);

/// Paints words in the library's stroke font, centred at a point, `height` pixels high.
void paint_words(Image& image, const std::string& words, double x, double y, double height, const Colour& colour,
                 double opacity = 1);

}  // namespace fieldfab::cam
