#include "files.h"

#include <fmt/format.h>

#include <algorithm>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/openscad/design.h"
#include "filters/bounds_text.h"
#include "solids.h"
#include "volume_import.h"

namespace fieldfab::meshlab {
namespace {

/// Returns the extensions of a kind in MeshLab's form: without the dot, and only the last part of
/// .nii.gz.
std::vector<std::string> extensions_of(FormatKind kind) {
  std::vector<std::string> extensions = extensions_read(kind);
  for (std::string& extension : extensions) extension.erase(0, extension.rfind('.') + 1);
  return extensions;
}

bool is_of(FormatKind kind, const std::string& extension) {
  const std::vector<std::string> extensions = extensions_of(kind);
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

}  // namespace

std::vector<FileKind> files_read() {
  return {{"Fieldfab distance field", extensions_of(FormatKind::distances)},
          {"Formula (f-rep)", extensions_of(FormatKind::formula)},
          {"OpenSCAD design", extensions_of(FormatKind::design)},
          {"CT volume or level set", extensions_of(FormatKind::volume)}};
}

std::vector<FileKind> files_written() { return {{"Fieldfab distance field", {"asdf"}}}; }

std::vector<Parameter> reading_parameters(const std::string& extension) {
  if (is_of(FormatKind::volume, extension)) return volume_parameters();
  std::vector<Parameter> rows{number_parameter(
      "Voxel", "Voxel (mm)",
      "Edge of the smallest cell of the mesh; 0 takes the file's own, or 1/128 of the longest side.", 0)};
  if (!is_of(FormatKind::distances, extension))
    rows.push_back(text_parameter(
        "Bounds", "Bounds (mm)",
        "x0,y0,z0,x1,y1,z1: the region to mesh if the solid is unbounded. Empty: the bounds are computed.", ""));
  return rows;
}

Layer read_file_as_layer(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log,
                         Progress& progress) {
  const Format* const format = openscad::all_formats().find(file);
  // MeshLab takes any .gz for a .nii.gz; the reader of volumes refuses the others.
  if (format == nullptr || format->kind == FormatKind::volume) return import_volume(file, values, log, progress);
  const bool bounded = format->kind == FormatKind::distances;
  const std::optional<Box> bounds = bounded ? std::nullopt : bounds_of(values.text("Bounds"));
  const Model model = model_of_file(file, progress);
  log = model.notes;
  Layer layer = layer_of(model, bounds, values.not_negative("Voxel"), EmptySolid::refused, file.filename().string(),
                         log, progress);
  if (layer.mesh.triangles.empty())
    throw Error(ErrorKind::bad_input, file.string(), "there is no solid within the bounds");
  return layer;
}

std::vector<Parameter> writing_parameters(const Document& document) { return fineness_parameters(document); }

void write_layer_as_asdf(const Layer& layer, const std::filesystem::path& file, const Values& values,
                         std::vector<std::string>& log, Progress& progress) {
  const Fineness fineness = fineness_of(values);
  const Solid solid = solid_of(layer, fineness, 0, log, progress);
  const auto asdf = Asdf::build(*solid.field, *solid.bounds, {fineness.voxel}, progress);
  asdf->save(file, {}, progress);
  log.push_back(fmt::format("{}: {} cells of {:.3g} mm and larger", file.filename().string(),
                            asdf->statistics().cells(), fineness.voxel));
}

}  // namespace fieldfab::meshlab
