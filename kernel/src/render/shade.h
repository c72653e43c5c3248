/// Shading of a height map.
#pragma once

#include "fieldfab/core/progress.h"
#include "fieldfab/render/image.h"
#include "raster.h"

namespace fieldfab {

/// Linear colour of parts without one.
inline const Eigen::Vector3f plain_material{0.80F, 0.83F, 0.88F};

/// Returns the linear colour of each pixel, from its height and normal alone: a warm key light with
/// soft shadows, a cool fill light, a rim light from behind, and ambient light from the visible
/// part of the sky. `materials` are the linear colours of the pixels; if empty, plain_material.
std::vector<Eigen::Vector3f> shade(const PixelGrid& grid, const std::vector<float>& heights, const Normals& normals,
                                   const std::vector<Eigen::Vector3f>& materials, Progress& progress);

}  // namespace fieldfab
