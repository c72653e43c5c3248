/// From a volume file to an isosurface: cropping, filtering and thresholding.
#pragma once

#include <filesystem>
#include <optional>

#include "fieldfab/volume/clean.h"
#include "fieldfab/volume/threshold.h"
#include "fieldfab/volume/volume_field.h"
#include "fieldfab/volume/volume_file.h"

namespace fieldfab {

/// Parameters for a volume.
struct ScanOptions {
  VolumeFileOptions file;
  std::optional<std::array<int, 6>> crop;  ///< sample range: first index along x, y, z, then last index along x, y, z
  CleanSettings clean;
  ThresholdRule threshold;
  bool below = false;                           ///< whether the solid has densities below the threshold
  std::size_t memory = std::size_t{512} << 20;  ///< memory for reading, bytes
};

/// A volume and its isosurface.
struct Scan {
  VolumePtr volume;
  Isosurface surface;
};

/// Applies the options to an open volume; ignores `options.file`. Throws as open_scan().
Scan take_scan(VolumePtr volume, const ScanOptions& options, Progress& progress = Progress::none());

/// Opens a volume, crops it, reduces noise, determines the threshold and removes small components. Throws as
/// open_volume(), threshold_by() and cleaned().
Scan open_scan(const std::filesystem::path& path, const ScanOptions& options, Progress& progress = Progress::none());

}  // namespace fieldfab
