/// Light on a height map.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/render/image.h"
#include "raster.h"

namespace fieldfab {

/// The linear colour of what has none of its own.
inline const Eigen::Vector3f plain_material{0.80F, 0.83F, 0.88F};

/// Linear colour of each pixel, from its height and normal alone: a warm key light with soft shadows, a cool fill light, a light
/// from behind that draws the outline, and the sky as far as it is open. `materials`: the pixels' own colours, linear; empty:
/// plain_material.
std::vector<Eigen::Vector3f> shade(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals,
                                   const std::vector<Eigen::Vector3f>& materials, Progress& progress);

}  // namespace fieldfab
