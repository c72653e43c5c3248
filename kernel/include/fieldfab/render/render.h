/// Pictures of any Field: 2D bitmap, height map, normals, shaded (Keeter 2.6, 2.7, 3.7, 3.10).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/render/image.h"

namespace fieldfab {

enum class RenderMode { bitmap, height, normals, shaded };
/// The mode of that name; throws bad_input naming the choices.
RenderMode render_mode(std::string_view name);

/// What to show and how.
struct RenderSettings {
  RenderMode mode = RenderMode::shaded;
  int size = 512;    ///< pixels along the longer side of the picture
  double alpha = 0;  ///< turn about z, radians (Keeter App. C)
  double beta = 0;   ///< then tilt about x, radians
  /// The angle that the solid's bounding ball fills in the eye, radians; 0 looks from infinitely far, at most 2 (115 degrees).
  double perspective = 0;
  int samples = 1;  ///< pixels an axis that are averaged into one of a shaded picture, 1 to 4
  /// The part of the picture's plane to show, x0, y0, x1, y1 in mm after the turn (z does not matter); all of the solid where not
  /// given. Every pixel is evaluated for its own place: nothing is enlarged.
  std::optional<Box> window = std::nullopt;
};

/// A part of what is shown, with a colour of its own.
struct ColouredPart {
  FieldPtr field;
  std::optional<Colour> colour;  ///< grey where there is none
};

/// Renders the part of `field` inside `bounds`, seen from +z after the turn. A bitmap shows the plane z = bounds.lower.z, sampled
/// at pixel centres: white inside. A height map has 16 bits: 0 is nothing, 1 .. 65535 run over zmin .. zmax. The same pixels for
/// any number of threads. Where `parts` are given, of which `field` is the union, each point of a shaded picture has the colour of
/// the part that it lies on: of the least value there. Throws bad_input, cancelled.
Image render(const Field& field, const Box& bounds, const RenderSettings& settings, Progress& progress = Progress::none(),
             std::span<const ColouredPart> parts = {});

}  // namespace fieldfab
