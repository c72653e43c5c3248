/// Flat shapes painted onto finished pictures: marks, numbers, legends.
#pragma once

#include "fieldfab/frep/expression.h"
#include "fieldfab/render/triangles.h"

namespace fieldfab::cam {

/// Paints the part of a flat shape that lies in a rectangle, both in pixels from the picture's lower left corner, y up. Its edges
/// are smooth where the shape is an exact distance. `opacity` from 0 to 1.
void paint(Image& image, const frep::Expression& shape, const Box& where, const Colour& colour, double opacity = 1);

/// Words in the library's stroke font, centred at a place, `height` pixels high.
void paint_words(Image& image, const std::string& words, double x, double y, double height, const Colour& colour,
                 double opacity = 1);

}  // namespace fieldfab::cam
