// Stages that convert the input: outlines, surfaces and bitmaps.
#include <fmt/format.h>

#include <cmath>

#include "fieldfab/cam/plan/distance.h"
#include "fieldfab/core/error.h"
#include "plan/silhouette.h"
#include "stages.h"

namespace fieldfab::cam {
namespace {

/// Default size of a region's squares: a fortieth of the tool's diameter, but not below a 2000th of
/// the region's longer side; in that case at most a quarter of the diameter, because corners are
/// inaccurate by up to one cell.
double cell_for(const Values& values, const Vec2& size, const Context& context) {
  if (is_set(values, "cell")) return values.number("cell");
  const double longest = size.maxCoeff(), tool = context.tool.diameter;
  if (!(tool > 0)) return longest / 1000;
  return std::max(std::min(longest / 2000, tool / 4), std::min(tool / 40, longest / 200));
}

Setting cell_setting() {
  return above_zero(
      number("cell", "mm", unset, "sample spacing; the default follows from the part's size and the tool"));
}

/// Contour of a slice. Squares are halved until no part is missed. If that fails, returns the
/// outline for the requested cell and adds a note on what it lacks.
Loops slice_of(const Field& solid, const Rectangle& bounds, double cell, double z, Context& context) {
  constexpr int halvings = 4;
  MissedParts missed;
  Loops loops = contours(solid, bounds, {cell, z}, missed, context.progress);
  MissedParts left = missed;
  for (int i = 1; i <= halvings && left.lost > 0; ++i) {
    Loops finer = contours(solid, bounds, {std::ldexp(cell, -i), z}, left, context.progress);
    if (left.lost == 0) loops = std::move(finer);
  }
  if (left.lost == 0) missed = left;
  if (missed.any())
    context.notes.push_back(fmt::format(
        "the outline {} parts narrower than {:.2g} mm, for example at x {:.2f}, y {:.2f}: give a smaller cell",
        missed.lost > 0 ? "lacks" : "may lack", cell, missed.place.x(), missed.place.y()));
  return loops;
}

/// Adds a note on places where a surface is raised above its proved height.
void note_doubtful(const Surface& surface, Context& context) {
  const Surface::Doubtful& doubtful = surface.doubtful();
  if (doubtful.count > 0)
    context.notes.push_back(fmt::format(
        "at {} places something thinner than {:.2g} mm may stand, for example at x {:.2f}, y {:.2f} up to z {:.2f}: "
        "the tool stays above it",
        doubtful.count, surface.samples().cell / std::max(1, surface.fine_side() - 1), doubtful.place.x(),
        doubtful.place.y(), doubtful.place.z()));
}

Artifact outline_of_solid(const Artifact& in, const Values& values, Context& context) {
  const Solid& solid = std::get<Solid>(in);
  const Rectangle bounds = Rectangle::of(*solid.bounds);
  const double cell = cell_for(values, bounds.size(), context);
  Loops loops;
  if (solid.flat || is_set(values, "slice")) {
    const double z = is_set(values, "slice") ? values.number("slice") : 0;
    loops = slice_of(*solid.field, bounds.grown(cell), cell, z, context);
  } else if (has_quick_silhouette(solid.field, *solid.bounds)) {
    const FieldPtr seen = silhouette(solid.field, solid.bounds->lower.z(), solid.bounds->upper.z());
    loops = slice_of(*seen, bounds.grown(cell), cell, 0, context);
  } else {
    // The contact of a thin needle from above, on the lattice of heights.
    const auto surface = Surface::of(*solid.field, *solid.bounds, {cell, std::min(cell / 4, 0.02)}, context.progress);
    note_doubtful(*surface, context);
    const auto needle = std::make_shared<TipSurface>(surface, Profile(0, 0, 0, 1e-6));
    loops = contours(*TipSurface::field(needle), bounds.grown(cell), {cell, 0, -(surface->floor() + 1e-3)},
                     context.progress);
  }
  if (loops.empty())
    throw Error(ErrorKind::bad_input, "outline",
                fmt::format("there is nothing of the part at cells of {:.4g} mm", cell));
  return Outline{outline_field(loops), bounds, cell};
}

Artifact surface_of_solid(const Artifact& in, const Values& values, Context& context) {
  const Solid& solid = std::get<Solid>(in);
  if (solid.flat)
    throw Error(ErrorKind::bad_input, "surface",
                "the model is flat: it has no surface to finish; use profile, pocket, isolate or v_carve");
  const double cell = cell_for(values, Rectangle::of(*solid.bounds).size(), context);
  auto surface = Surface::of(*solid.field, *solid.bounds, {cell, values.number("surface_tolerance")}, context.progress);
  note_doubtful(*surface, context);
  return surface;
}

double pixel_of(const Image& image, const Values& values) {
  if (is_set(values, "pixel")) return values.number("pixel");
  if (image.pixels_per_mm > 0) return 1 / image.pixels_per_mm;
  throw Error(ErrorKind::bad_input, "image", "the picture has no physical size; give pixel (mm) or dpi");
}

/// Brightness of a pixel from 0 to 1; row 0 is the lowest.
double brightness(const Image& image, int column, int row) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t i = (static_cast<std::size_t>(image.height - 1 - row) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(column)) *
                        channels;
  double sum = 0;
  for (std::size_t c = 0; c < channels; ++c)
    sum += image.depth == 16 ? image.pixels16[i + c] / 65535.0 : image.pixels8[i + c] / 255.0;
  return sum / static_cast<double>(channels);
}

Artifact bitmap_of_image(const Artifact& in, const Values& values, Context&) {
  const Image& image = std::get<Image>(in);
  const double pixel = pixel_of(image, values), threshold = values.number("threshold");
  const bool invert = values.flag("invert");
  // One row of empty pixels on each side closes outlines at the border.
  Bitmap bitmap(image.width + 2, image.height + 2, pixel, Vec2::Constant(-0.5 * pixel), 0);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      bitmap.at(column + 1, row + 1) = (brightness(image, column, row) > threshold) != invert ? 1 : 0;
  return bitmap;
}

Artifact outline_of_bitmap(const Artifact& in, const Values&, Context& context) {
  const Bitmap& bitmap = std::get<Bitmap>(in);
  Lattice<float> distance = signed_distance(bitmap, context.progress);
  return Outline{lattice_field(std::move(distance)), bitmap.extent(), bitmap.cell};
}

Artifact surface_of_image(const Artifact& in, const Values& values, Context&) {
  const Image& image = std::get<Image>(in);
  const double pixel = pixel_of(image, values);
  double low = values.number("black"), high = values.number("white");
  if (image.has_heights && low == unset) low = image.bounds.lower.z();
  if (image.has_heights && high == unset) high = image.bounds.upper.z();
  if (low == unset || high == unset)
    throw Error(ErrorKind::bad_input, "image", "the picture has no heights; give black and white, mm");
  HeightMap map(image.width, image.height, pixel, Vec2::Constant(0.5 * pixel), 0);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      map.at(column, row) = static_cast<float>(low + (high - low) * brightness(image, column, row));
  return Surface::of(std::move(map), std::min(low, high));
}

}  // namespace

std::vector<Stage> conversion_stages() {
  const Setting pixel =
      above_zero(number("pixel", "mm", unset, "size of a pixel; the default is that of the image file"));
  return {
      {"outline",
       "the part's outline: a slice, or its shadow from above",
       Kind::solid,
       Kind::outline,
       false,
       {cell_setting(),
        number(
            "slice", "mm", unset,
            "height of the section through the part; the default is the projection from above, or the drawing itself")},
       outline_of_solid},
      {"height map",
       "the part's upper surface",
       Kind::solid,
       Kind::surface,
       false,
       {cell_setting(), above_zero(number("surface_tolerance", "mm", 0.01,
                                          "greatest distance of the height map from the part's surface"))},
       surface_of_solid},
      {"threshold",
       "black and white",
       Kind::image,
       Kind::bitmap,
       false,
       {pixel, between(0, 1, number("threshold", "", 0.5, "brighter pixels are solid")),
        flag("invert", false, "invert: darker pixels are solid")},
       bitmap_of_image},
      {"distance transform",
       "exact distances to the bitmap's edge",
       Kind::bitmap,
       Kind::outline,
       false,
       {},
       outline_of_bitmap},
      {"heights",
       "a height map as drawn",
       Kind::image,
       Kind::surface,
       false,
       {pixel, number("black", "mm", unset, "height of black; the default is that of the image file"),
        number("white", "mm", unset, "height of white; the default is that of the image file")},
       surface_of_image},
  };
}

}  // namespace fieldfab::cam
