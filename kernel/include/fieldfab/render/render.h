/// Pictures of any Field: 2D bitmap, height map, normals, shaded view (Keeter 2.6, 2.7, 3.7, 3.10).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/render/image.h"

namespace fieldfab {

/// Kind of picture.
enum class RenderMode { bitmap, height, normals, shaded };
/// Returns the mode of that name. Throws Error(bad_input) with the choices.
RenderMode render_mode(std::string_view name);

/// Parameters of a picture.
struct RenderSettings {
  RenderMode mode = RenderMode::shaded;
  int size = 512;    ///< longer side of the picture, pixels
  double alpha = 0;  ///< rotation about z, radians (Keeter Appendix C)
  double beta = 0;   ///< then rotation about x, radians
  /// Visual angle of the solid's bounding ball, radians, at most 2 (115 degrees); 0: orthographic projection.
  double perspective = 0;
  int samples = 1;  ///< supersampling of shaded pictures: samples per pixel and axis, 1 to 4
  /// Window in the picture's plane, mm after the rotation (x and y; z is ignored); default: the whole solid. Each pixel
  /// is evaluated at its own position, so that magnification loses no detail.
  std::optional<Box> window = std::nullopt;
};

/// A part of the solid with its own colour.
struct ColouredPart {
  FieldPtr field;
  std::optional<Colour> colour;  ///< std::nullopt: grey
};

/// Renders the part of `field` inside `bounds`, seen from +z after the rotation.
/// - A bitmap shows the plane z = bounds.lower.z, sampled at pixel centres; white is inside.
/// - A height map has 16 bits: 0 is background, 1 to 65535 correspond to zmin to zmax.
/// - If `parts` are given, `field` must be their union. Each point of a shaded picture has the colour of the part with
///   the least value there.
/// NaN is outside. The pixels do not depend on the number of threads. Throws Error(bad_input), Error(cancelled).
Image render(const Field& field, const Box& bounds, const RenderSettings& settings,
             Progress& progress = Progress::none(), std::span<const ColouredPart> parts = {});

}  // namespace fieldfab
