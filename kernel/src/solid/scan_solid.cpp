#include "fieldfab/solid/scan_solid.h"

namespace fieldfab {

std::vector<LatticeSource> lattices_of(const Scan& scan, int levels_wanted) {
  std::vector<LatticeSource> levels;
  VolumePtr volume = scan.volume;
  for (int level = 0; level < levels_wanted; ++level) {
    if (level > 0) volume = halved(std::move(volume));
    const SampleLattice& lattice = volume->lattice();
    levels.push_back({lattice.box(), lattice.size, lattice.placement(),
                      [volume, surface = scan.surface](int first, int count, float* out) {
                        volume->read(first, count, out);
                        const std::size_t samples = static_cast<std::size_t>(count) * volume->lattice().slice();
                        for (std::size_t i = 0; i < samples; ++i) out[i] = surface.value(out[i]);
                      }});
  }
  return levels;
}

ImportCounts import_scan(const Scan& scan, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress) {
  return import_asdf(lattices_of(scan, settings.file.levels), path, settings, progress);
}

std::shared_ptr<OpenedSolid> opened_scan(const Scan& scan, Progress& progress) {
  const SampleLattice& lattice = scan.volume->lattice();
  auto opened = std::make_shared<OpenedSolid>();
  opened->kind = "volume";
  opened->field = volume_field(*scan.volume, scan.surface, progress);
  opened->voxel = lattice.spacing.minCoeff();
  const Eigen::Affine3d placement = lattice.placement();
  opened->bounds = image_of(lattice.box(), placement.linear(), placement.translation());
  return opened;
}

}  // namespace fieldfab
