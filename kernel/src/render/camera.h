/// View of a solid for rendering.
#pragma once

#include "fieldfab/render/render.h"
#include "raster.h"

namespace fieldfab {

/// A solid in the coordinates of its image: x to the right, y up, z towards the eye.
struct View {
  FieldPtr field;
  Box region;                  ///< part of space that the image shows
  double distance = 0;         ///< from the eye to the solid's middle, mm; 0 if it is infinitely far
  Vec3 centre = Vec3::Zero();  ///< that middle, if the distance is finite
};

/// Returns the part of `field` inside `bounds`, rotated and in perspective by the settings. Throws
/// bad_input.
View look(const Field& field, const Box& bounds, const RenderSettings& settings);

/// Converts normals of View::field, at the pixels that see it, to normals of the solid.
void straighten(const View& view, const PixelGrid& grid, const std::vector<float>& heights, Normals& normals);

}  // namespace fieldfab
