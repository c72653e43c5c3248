/// Functions for volumes in library parts that are loaded on first use (core/module.h).
#pragma once

#include "fieldfab/volume/clean.h"
#include "volume/readers.h"

namespace fieldfab {

/// Functions of the part "itk", exported as `fieldfab_itk`. Each is the implementation of the
/// function without "itk"; see readers.h and clean.h.
struct ItkPart {
  VolumePtr (*open)(const Path& path, Progress& progress);
  VolumePtr (*open_dicom)(const Path& path, const std::string& series, Progress& progress);
  void (*write)(const Volume& volume, const Path& path, Progress& progress);
  VolumePtr (*denoised)(const VolumePtr& volume, const Denoising& denoising, Progress& progress);
};

/// Implementation of denoised() in the part, without its check for nothing to do.
VolumePtr itk_denoised(const VolumePtr& volume, const Denoising& denoising, Progress& progress);

/// Functions of the part "openvdb", exported as `fieldfab_vdb_volume`.
struct VdbVolumePart {
  VolumePtr (*open)(const Path& path, Progress& progress);
};

}  // namespace fieldfab
