#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

double positive(const std::optional<double>& value, const char* option) {
  if (!std::isfinite(*value) || *value <= 0)
    throw Error(ErrorKind::bad_input, option, fmt::format("{} is not a positive number", *value));
  return *value;
}

FieldPtr plate(const FieldPtr& flat, double height) {
  constexpr double wide = 1e9;
  return intersect(flat, box_field({{-wide, -wide, 0}, {wide, wide, height}}));
}

}  // namespace

void ModelOptions::declare(CLI::App& verb, const std::string& output_help) {
  verb.add_option("MODEL", model,
                  "the solid: .math .vm .frep .py .scad .csg .asdf, a mesh (.stl .ply .off .obj .3mf), or a CT volume")
      ->required();
  if (!output_help.empty()) verb.add_option("-o,--output", output, output_help)->required();
  auto* resolution_option = verb.add_option("--resolution", resolution, "smallest cells a mm");
  verb.add_option("--voxel", voxel, "edge of the smallest cell in mm; the default is 1/128 of the longest side")
      ->excludes(resolution_option);
  verb.add_option("--max-error", max_error,
                  "how far the result may be from the solid in mm; the default is a tenth of the smallest cell");
  verb.add_option("--bounds,--region", bounds, "the region, x0,y0,z0,x1,y1,z1 in mm; found where not given");
  verb.add_option("--thickness", thickness, "make a plate of a flat (2D) model: z from 0 to this many mm");
  verb.add_option("--level", level, "of an .asdf file with several resolutions; 0 is the finest")->check(CLI::Range(0, 31));
  verb.add_flag("--smooth", smooth, "of an OpenSCAD design: true circles and spheres, not faceted as OpenSCAD draws them");
  scan.declare(verb);
}

std::optional<Box> ModelOptions::region() const {
  if (bounds.empty()) return std::nullopt;
  std::array<double, 6> number{};
  const char* at = bounds.data();
  const char* end = at + bounds.size();
  for (std::size_t i = 0; i < number.size(); ++i) {
    while (at < end && (*at == ' ' || *at == '+')) ++at;
    const auto [next, failure] = std::from_chars(at, end, number[i]);
    const bool comma = next < end && *next == ',';
    if (failure != std::errc{} || comma != (i < 5) || (i == 5 && next != end))
      throw Error(ErrorKind::bad_input, "--bounds",
                  fmt::format("expected six numbers x0,y0,z0,x1,y1,z1, found '{:.60}'", bounds));
    at = next + 1;
  }
  return Box{{number[0], number[1], number[2]}, {number[3], number[4], number[5]}};
}

Model ModelOptions::load(Progress& progress) const {
  Model loaded = load_model(model, Scripts::run, progress, scan.parsed(), {level, region()},
                            smooth ? Roundness::smooth : Roundness::as_drawn);
  print_notes(loaded.notes);
  if (thickness) loaded.field = plate(loaded.field, positive(thickness, "--thickness"));
  return loaded;
}

std::optional<double> ModelOptions::make_plate_if_flat(Model& loaded, Progress& progress) {
  if (thickness || !bounds.empty() || loaded.voxel) return std::nullopt;
  const SolidBounds found = solid_bounds(*loaded.field, progress);
  if (found.empty || !found.bounded[0] || !found.bounded[1] || found.bounded[2]) return std::nullopt;
  constexpr double cells_a_side = 512, cells_thick = 8;
  const double side = std::max(found.box.size().x(), found.box.size().y());
  if (!voxel && !resolution) voxel = side / cells_a_side;
  const double height = cells_thick * cell(found.box, loaded);
  loaded.field = plate(loaded.field, height);
  return height;
}

bool ModelOptions::takes_samples() const {
  return is_volume_path(model) && !voxel && !resolution && bounds.empty() && !thickness;
}

double ModelOptions::cell(const Box& region, const Model& loaded) const {
  if (max_error && !(*max_error >= 0 && std::isfinite(*max_error)))
    throw Error(ErrorKind::bad_input, "--max-error", fmt::format("{} is not a number of mm from 0 up", *max_error));
  if (voxel) return positive(voxel, "--voxel");
  if (resolution) return 1 / positive(resolution, "--resolution");
  if (loaded.voxel) return *loaded.voxel;
  return region.size().maxCoeff() / 128;
}

}  // namespace fieldfab::cli
