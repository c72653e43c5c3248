/// Where a picture is taken from.
#pragma once

#include "fieldfab/render/render.h"
#include "raster.h"

namespace fieldfab {

/// A solid in the coordinates of its picture: x to the right, y up, z towards the eye.
struct View {
  FieldPtr field;
  Box region;                  ///< what the picture shows
  double distance = 0;         ///< from the eye to the solid's middle; 0 where it is infinitely far
  Vec3 centre = Vec3::Zero();  ///< that middle, where there is an eye
};

/// The part of `field` inside `bounds`, turned and seen as the settings ask. Throws bad_input.
View look(const Field& field, const Box& bounds, const RenderSettings& settings);

/// Turns normals of View::field at the pixels that see it into normals of the solid itself.
void straighten(const View& view, const PixelGrid& grid, const std::vector<float>& heights, Normals& normals);

}  // namespace fieldfab
