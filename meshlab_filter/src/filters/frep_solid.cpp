// Solid from a formula.
#include <fmt/format.h>

#include <sstream>

#include "../solids.h"
#include "all.h"
#include "bounds_text.h"
#include "fieldfab/core/error.h"

namespace fieldfab::meshlab {

std::optional<Box> bounds_of(const std::string& text) {
  if (text.find_first_not_of(" \t") == std::string::npos) return std::nullopt;
  std::string spaced = text;
  for (char& c : spaced)
    if (c == ',' || c == ';') c = ' ';
  std::istringstream numbers(spaced);
  numbers.imbue(std::locale::classic());
  Box box;
  std::string rest;
  numbers >> box.lower.x() >> box.lower.y() >> box.lower.z() >> box.upper.x() >> box.upper.y() >> box.upper.z();
  if (numbers.fail() || (numbers >> rest) || !box.valid())
    throw Error(ErrorKind::bad_input, "Bounds", fmt::format("'{}' is not x0,y0,z0,x1,y1,z1 in mm", text));
  return box;
}

namespace {

std::vector<Parameter> frep_solid_parameters(const Document&) {
  return {text_parameter(
              "Formula", "Formula or file",
              "The language of docs/frep-language.md, such as difference(sphere(10), cylinder(4, 40)), or max(x^2 + "
              "y^2 - 25, "
              "abs(z) - 3); or the path of a file of any kind: formula, distance field, OpenSCAD design, mesh, volume.",
              "smooth_union(sphere(10), move(box(12, 12, 12), 9, 0, 0), 3)"),
          text_parameter(
              "Bounds", "Bounds (mm)",
              "x0,y0,z0,x1,y1,z1: the region to mesh if the solid is unbounded. Empty: the bounds are computed.", ""),
          number_parameter("Voxel", "Voxel (mm)",
                           "Edge of the smallest cell; 0 takes the file's own, or 1/128 of the longest side.", 0)};
}

Result run_frep_solid(const Values& values, Progress& progress) {
  Result result;
  const double voxel = values.not_negative("Voxel");
  const std::string& text = values.text("Formula");
  const std::optional<Box> bounds = bounds_of(values.text("Bounds"));
  const Model model = model_of_text(text, progress);
  result.log = model.notes;
  for (const Solid& part : model.parts) {
    const std::string name = !part.name.empty() ? part.name : text.size() < 40 ? text : "formula";
    const EmptySolid empty = model.parts.size() > 1 ? EmptySolid::allowed : EmptySolid::refused;
    Layer layer = layer_of(Model{{part}}, bounds, voxel, empty, name, result.log, progress);
    if (!layer.mesh.triangles.empty()) result.layers.push_back(std::move(layer));
  }
  if (result.layers.empty()) throw Error(ErrorKind::bad_input, "result", "there is no solid within the bounds");
  return result;
}

}  // namespace

Filter frep_solid() {
  return {"Fieldfab: Solid from f-rep expression",
          "A solid from a formula (functional representation), which is negative inside. The mesh is closed and has "
          "sharp edges. The result is a new layer; of a model with several parts, one layer for each, with its name "
          "and colour.",
          Filter::Group::creation,
          false,
          false,
          frep_solid_parameters,
          run_frep_solid};
}

}  // namespace fieldfab::meshlab
