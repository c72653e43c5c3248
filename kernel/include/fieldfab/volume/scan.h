/// From a volume's file to a surface in it, with what is asked for on the way.
#pragma once

#include <filesystem>
#include <optional>

#include "fieldfab/volume/clean.h"
#include "fieldfab/volume/threshold.h"
#include "fieldfab/volume/volume_field.h"
#include "fieldfab/volume/volume_file.h"

namespace fieldfab {

/// How to take a volume.
struct ScanOptions {
  VolumeFileOptions file;
  std::optional<std::array<int, 6>> crop;  ///< first sample along x, y, z, then last
  CleanSettings clean;
  ThresholdRule threshold;
  bool below = false;                           ///< solid is what is less dense
  std::size_t memory = std::size_t{512} << 20;  ///< bytes that reading may hold at a time
};

/// A volume and the surface wanted.
struct Scan {
  VolumePtr volume;
  Isosurface surface;
};

/// The same with a volume that is open already; `options.file` means nothing.
Scan take_scan(VolumePtr volume, const ScanOptions& options, Progress& progress = Progress::none());

/// Opens, crops, denoises, finds the threshold, and cleans. Throws as open_volume(), threshold_by() and clean() do.
Scan open_scan(const std::filesystem::path& path, const ScanOptions& options, Progress& progress = Progress::none());

}  // namespace fieldfab
