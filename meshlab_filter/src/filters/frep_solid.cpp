// A solid from a formula.
#include <fmt/format.h>

#include <sstream>

#include "../cost.h"
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

std::vector<Parameter> parameters(const Document&) {
  return {text_parameter(
              "Formula", "Formula or file",
              "The language of docs/frep-language.md, such as difference(sphere(10), cylinder(4, 40)), or max(x^2 + y^2 - 25, "
              "abs(z) - 3); or the path of a .frep, .math or .vm file.",
              "smooth_union(sphere(10), move(box(12, 12, 12), 9, 0, 0), 3)"),
          text_parameter("Bounds", "Bounds (mm)",
                         "x0,y0,z0,x1,y1,z1: of a solid that goes on without end, the part to take. Empty: they are found.", ""),
          number_parameter("Voxel", "Voxel (mm)", "Edge of the smallest cell; 0 takes 1/128 of the longest side.", 0)};
}

Result run(const Values& values, Progress& progress) {
  Result result;
  double voxel = values.not_negative("Voxel");
  const std::string& text = values.text("Formula");
  const Solid solid = solid_of_text(text, bounds_of(values.text("Bounds")), progress);
  if (voxel == 0) voxel = solid.bounds.size().maxCoeff() / 128;
  const Vec3 size = solid.bounds.size();
  require(surface_cost(2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()), voxel), voxel, 2);
  result.layer = layer_of(solid.field, solid.bounds, {voxel}, true, text.size() < 40 ? text : "formula", result.log, progress);
  const TriangleMesh& mesh = result.layer->mesh;
  result.log.push_back(fmt::format("{} triangles, {:.6g} mm3, {:.6g} mm2, voxel {:.3g} mm", mesh.triangles.size(), mesh.volume(),
                                   mesh.area(), voxel));
  return result;
}

}  // namespace

Filter frep_solid() {
  return {"Fieldfab: Solid from f-rep expression",
          "A solid from a formula (a functional representation): below 0 is inside. Edges are sharp, the mesh is closed. The "
          "result is a new layer.",
          Filter::Group::creation,
          false,
          false,
          parameters,
          run};
}

}  // namespace fieldfab::meshlab
