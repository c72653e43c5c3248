#include "volume_import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cost.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/lower_case.h"
#include "fieldfab/solid/scan_solid.h"
#include "solids.h"

namespace fieldfab::meshlab {
namespace {

/// Returns the folder of a slice, which stands for the whole stack.
std::filesystem::path whole_volume(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension != ".tif" && extension != ".tiff" && extension != ".png" && extension != ".dcm") return file;
  std::size_t slices = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::absolute(file).parent_path()))
    slices += entry.path().extension() == file.extension() ? 1 : 0;
  return slices > 1 ? std::filesystem::absolute(file).parent_path() : file;
}

}  // namespace

std::vector<std::string> volume_patterns() {
  std::vector<std::string> patterns;
  for (const std::string& extension : extensions_read(FormatKind::volume)) patterns.push_back("*" + extension);
  return patterns;
}

std::string volume_patterns_text() { return fmt::format("{}", fmt::join(volume_patterns(), " ")); }

std::vector<Parameter> volume_parameters() {
  return {text_parameter("Threshold", "Threshold",
                         "The density that separates solid from nothing: a number, otsu, halfway, 90% (of the samples "
                         "are below), or automatic.",
                         "automatic"),
          flag_parameter("Below", "Solid is what is less dense", "As air or pores.", false),
          text_parameter("Denoise", "Denoise", "none, median:1 (samples), gaussian:0.8 (mm) or anisotropic:1.", "none"),
          flag_parameter("KeepLargest", "Only the largest piece", "Without dust and whatever else lay in the scanner.",
                         false),
          number_parameter("Voxel", "Voxel (mm)", "Edge of the smallest cell; 0 takes the scan's own.", 0)};
}

Layer import_volume(const std::filesystem::path& file, const Values& values, std::vector<std::string>& log,
                    Progress& progress) {
  if (file.empty()) throw Error(ErrorKind::bad_input, "File", "choose a volume");
  double voxel = values.not_negative("Voxel");
  ScanOptions options;
  if (const std::string& text = values.text("Threshold"); !text.empty() && text != "automatic")
    options.threshold = ThresholdRule::parse(text);
  options.below = values.flag("Below");
  options.clean.denoise = Denoising::parse(values.text("Denoise"));
  options.clean.keep_largest = values.flag("KeepLargest");
  const std::filesystem::path path = whole_volume(file);
  const Scan scan = open_scan(path, options, progress);
  const SampleLattice& lattice = scan.volume->lattice();
  log.push_back(fmt::format("{}: {} x {} x {} samples of {:.4g} x {:.4g} x {:.4g} mm, threshold {:.6g}",
                            path.filename().string(), lattice.size[0], lattice.size[1], lattice.size[2],
                            lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z(), scan.surface.threshold));
  const auto solid = opened_scan(scan, progress);
  if (voxel == 0) voxel = *solid->voxel;
  const Box bounds = solid->bounds->grown(voxel);
  require_surface(bounds, voxel);
  Layer layer = layer_of(solid->field, bounds, {voxel}, false, path.filename().string(), log, progress);
  log.push_back(fmt::format("{} triangles, {:.6g} mm3, {:.6g} mm2, voxel {:.3g} mm", layer.mesh.triangles.size(),
                            layer.mesh.volume(), layer.mesh.area(), voxel));
  return layer;
}

}  // namespace fieldfab::meshlab
