/// Pictures of triangulated surfaces, such as simulated stock, with vertex colours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/render/image.h"
#include "fieldfab/render/render.h"

namespace fieldfab {

/// A view of triangles in the layout of TriangleMesh; the arrays are not owned.
struct Triangles {
  std::span<const std::array<float, 3>> vertices;  ///< vertex positions, mm
  /// vertex indices, counter-clockwise seen from outside
  std::span<const std::array<std::uint32_t, 3>> triangles;
  /// colour per vertex, interpolated; empty: one material
  std::span<const Colour> colours;
};

/// A picture, and its relation to model coordinates.
struct TrianglePicture {
  Image image;
  std::vector<float> heights;  ///< depth per pixel, mm towards the eye; -infinity for background
  /// rotation from model to picture coordinates: x to the right, y up, z towards the eye
  Eigen::Matrix3d turn;

  /// Projects a point of the model: returns column and row in pixels (the centre of the first pixel is 0.5, 0.5), and
  /// depth, mm.
  [[nodiscard]] Vec3 on_picture(const Vec3& place) const;
  /// Whether the point is in the picture and no surface lies more than `slack` mm in front of it.
  [[nodiscard]] bool shows(const Vec3& place, double slack) const;
};

/// Renders both sides of triangles as shaded view, normals or height map, seen from +z after the rotation. The default
/// window contains all triangles with a margin. Lights and shadows are those of render() for Fields. Time and memory
/// are linear in the number of triangles and pixels. The pixels do not depend on the number of threads. Throws
/// Error(bad_input) (also for a perspective, and for no triangles without a window), Error(cancelled).
TrianglePicture render(const Triangles& triangles, const RenderSettings& settings,
                       Progress& progress = Progress::none());

}  // namespace fieldfab
