/// Pictures of surfaces that are triangles already, such as simulated stock, in colours of their own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/colour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/render/image.h"
#include "fieldfab/render/render.h"

namespace fieldfab {

/// A view of somebody's triangles, as TriangleMesh has them.
struct Triangles {
  std::span<const std::array<float, 3>> vertices;           ///< mm
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< triples of vertices, counter-clockwise seen from outside
  std::span<const Colour> colours;                          ///< of each vertex, even between them; empty: all of one material
};

/// A picture, and where in it the places of the model are.
struct TrianglePicture {
  Image image;
  std::vector<float> heights;  ///< of what each pixel shows, mm towards the eye; -infinity where that is nothing
  Eigen::Matrix3d turn;        ///< from the model's coordinates to the picture's: x to the right, y up, z towards the eye

  /// Where a place is: its column and row in pixels (the middle of the first pixel is 0.5, 0.5), and its height.
  [[nodiscard]] Vec3 on_picture(const Vec3& place) const;
  /// Whether it is within the picture and nothing stands more than `slack` mm before it.
  [[nodiscard]] bool shows(const Vec3& place, double slack) const;
};

/// Renders triangles shaded, as normals or as a height map, seen from +z after the turn; both of their sides are drawn. What is
/// shown without a window is all of them, with a margin. Lights and shadows are those of the pictures of Fields. Time and memory
/// go with the number of triangles and of pixels. The same pixels for any number of threads. Throws bad_input (also for a
/// perspective, or for nothing to be seen where there is no window), cancelled.
TrianglePicture render(const Triangles& triangles, const RenderSettings& settings, Progress& progress = Progress::none());

}  // namespace fieldfab
