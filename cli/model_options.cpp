#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"
#include "json.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

double positive(const std::optional<double>& value, const char* option) {
  if (!std::isfinite(*value) || *value <= 0)
    throw Error(ErrorKind::bad_input, option, fmt::format("{} is not a positive number", *value));
  return *value;
}

}  // namespace

void ModelOptions::declare(CLI::App& verb, const std::string& output_help) {
  verb.add_option("MODEL", model, "the solid: " + openscad::all_formats().readable())->required();
  if (!output_help.empty()) verb.add_option("-o,--output", output, output_help)->required();
  auto* resolution_option = verb.add_option("--resolution", resolution, "number of smallest cells per mm");
  verb.add_option("--voxel", voxel, "edge of the smallest cell in mm; the default is 1/128 of the longest side")
      ->excludes(resolution_option);
  verb.add_option("--max-error", max_error,
                  "greatest distance of the result from the solid in mm; the default is a tenth of the smallest cell");
  verb.add_option("--bounds,--region", bounds, "the region, x0,y0,z0,x1,y1,z1 in mm; computed by default");
  verb.add_option("--part", part, "of a model with several parts: only the part with this name");
  verb.add_option("--thickness", thickness, "make a plate of a flat (2D) model: z from 0 to this many mm");
  verb.add_option("--level", level, "of an .asdf file with several resolutions; 0 is the finest")
      ->check(CLI::Range(0, 31));
  verb.add_flag("--smooth", smooth,
                "of an OpenSCAD design: true circles and spheres, not faceted as OpenSCAD draws them");
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

Model ModelOptions::open(Progress& progress) const {
  OpenSettings settings;
  settings.scripts = Scripts::run;
  settings.options = scan.options();
  if (level != 0) settings.options.push_back({"level", static_cast<double>(level)});
  if (smooth) settings.options.push_back({"smooth", 1.0});
  settings.region = region();
  settings.formats = &openscad::all_formats();
  Model opened = open_model(model, settings, progress);
  print_notes(opened.notes);
  if (!part.empty()) opened.parts = {part_of(opened, part, "--part")};
  if (thickness)
    for (Solid& solid : opened.parts) solid = plate_of(solid, positive(thickness, "--thickness"));
  return opened;
}

Solid ModelOptions::as_one(const Model& opened, Progress& progress) const {
  tell_empty_parts(opened, model, progress);
  tell_parts_lost(opened.parts.size(), output);
  return united(opened);
}

void tell_parts_lost(std::size_t parts, const std::string& output) {
  if (parts < 2) return;
  const bool coloured = extension_of(output) == ".ply";
  print_notes({fmt::format("{}: {} parts are one there, without their names{}", output, parts,
                           coloured ? "" : " and colours")});
}

std::string place_of(const Solid& part, const Model& model, const std::string& file) {
  const std::string& place = part.place.empty() ? file : part.place;
  return model.parts.size() > 1 ? fmt::format("{}: part '{}'", place, part.name) : place;
}

void tell_empty_parts(const Model& model, const std::string& file, Progress& progress) {
  if (model.parts.size() < 2) return;
  for (const Solid& part : model.parts)
    if (!part.bounds && solid_bounds(*part.field, progress).empty)
      print_notes({place_of(part, model, file) + ": the solid is empty"});
}

std::optional<double> ModelOptions::make_plate_if_flat(Solid& solid, Progress& progress) {
  if (thickness || !bounds.empty() || (solid.voxel && !solid.flat)) return std::nullopt;
  const SolidBounds found = solid_bounds(*solid.field, progress);
  if (found.empty || !found.bounded[0] || !found.bounded[1] || found.bounded[2]) return std::nullopt;
  constexpr double cells_a_side = 512, cells_thick = 8;
  const double side = std::max(found.box.size().x(), found.box.size().y());
  if (!voxel && !resolution) voxel = side / cells_a_side;
  const double height = cells_thick * cell(found.box, solid);
  solid = plate_of(solid, height);
  return height;
}

bool ModelOptions::takes_samples() const {
  return openscad::all_formats().is_read_as(FormatKind::volume, model) && !voxel && !resolution && bounds.empty() &&
         !thickness;
}

Resolution ModelOptions::wanted() const {
  if (max_error && !(*max_error >= 0 && std::isfinite(*max_error)))
    throw Error(ErrorKind::bad_input, "--max-error", fmt::format("{} is not a number of mm from 0 up", *max_error));
  Resolution wanted;
  wanted.max_error = max_error;
  wanted.region = region();
  if (voxel) wanted.voxel = positive(voxel, "--voxel");
  if (resolution) wanted.voxel = 1 / positive(resolution, "--resolution");
  return wanted;
}

LatticeCells ModelOptions::lattice_cells(const Box& region, const Solid& solid, Progress& progress) const {
  const std::optional<double> cell = wanted().voxel;
  if (!cell) return fieldfab::lattice_cells(solid, region, progress);
  return {*cell, certainty_of_cells(*solid.field, region, *cell, progress)};
}

double ModelOptions::cell(const Box& region, const Solid& solid) const {
  return wanted().voxel.value_or(default_voxel(solid, region));
}

void tell_certainty(const Certainty& certainty, Outcome& outcome) {
  outcome.json["certain"] = certainty.certain();
  if (!certainty.certain()) outcome.json["uncertain"] = json_of(certainty);
}

}  // namespace fieldfab::cli
