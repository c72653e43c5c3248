#include "files.h"

#include <fmt/format.h>

#include <algorithm>

#include "cost.h"
#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"
#include "filters/bounds_text.h"
#include "solids.h"
#include "volume_import.h"

namespace fieldfab::meshlab {
namespace {

const std::vector<std::string> volumes{"vdb",  "vol", "vgi", "raw", "mha",  "mhd", "nrrd",
                                       "nhdr", "nii", "gz",  "tif", "tiff", "dcm"};

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension.empty() ? extension : extension.substr(1);
}

bool is_volume(const std::string& extension) { return std::find(volumes.begin(), volumes.end(), extension) != volumes.end(); }

}  // namespace

std::vector<FileKind> files_read() {
  return {
      {"Fieldfab distance field", {"asdf"}}, {"Formula (f-rep)", {"frep", "math", "vm"}}, {"CT volume or level set", volumes}};
}

std::vector<FileKind> files_written() { return {{"Fieldfab distance field", {"asdf"}}}; }

std::vector<Parameter> reading_parameters(const std::string& extension) {
  if (is_volume(extension)) return volume_parameters();
  std::vector<Parameter> rows{number_parameter(
      "Voxel", "Voxel (mm)", "Edge of the smallest cell of the mesh; 0 takes the file's own, or 1/128 of the longest side.", 0)};
  if (extension != "asdf")
    rows.push_back(
        text_parameter("Bounds", "Bounds (mm)",
                       "x0,y0,z0,x1,y1,z1: of a solid that goes on without end, the part to take. Empty: they are found.", ""));
  return rows;
}

Layer read_file_as_layer(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log,
                         Progress& progress) {
  const std::string extension = extension_of(file);
  if (is_volume(extension)) return import_volume(file, values, log, progress);
  double voxel = values.not_negative("Voxel");
  const fieldfab::Solid solid = united(open_model(file, {}, progress));
  const Box bounds =
      working_bounds(solid, extension == "asdf" ? std::optional<Box>{} : bounds_of(values.text("Bounds")), progress);
  if (voxel == 0) voxel = default_voxel(solid, bounds);
  const Vec3 size = bounds.size();
  require(surface_cost(2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()), voxel), voxel, 2);
  Layer layer = layer_of(solid.field, bounds, {voxel}, true, file.filename().string(), log, progress);
  log.push_back(fmt::format("{}: {}, {} triangles, {:.6g} mm3, voxel {:.3g} mm", file.filename().string(), solid.kind,
                            layer.mesh.triangles.size(), layer.mesh.volume(), voxel));
  return layer;
}

std::vector<Parameter> writing_parameters(const Document& document) { return fineness_parameters(document); }

void write_layer_as_asdf(const Layer& layer, const std::filesystem::path& file, const Values& values,
                         std::vector<std::string>& log, Progress& progress) {
  const Fineness fineness = fineness_of(values);
  const Solid solid = solid_of(layer, fineness, 0, log, progress);
  const auto asdf = Asdf::build(*solid.field, solid.bounds, {fineness.voxel}, progress);
  asdf->save(file, {}, progress);
  log.push_back(
      fmt::format("{}: {} cells of {:.3g} mm and larger", file.filename().string(), asdf->statistics().cells(), fineness.voxel));
}

}  // namespace fieldfab::meshlab
