/// What the parts that are loaded when first used (core/module.h) do for volumes.
#pragma once

#include "fieldfab/volume/clean.h"
#include "volume/readers.h"

namespace fieldfab {

/// Of the part "itk", as `fieldfab_itk`. Each is what the function without "itk" does; see readers.h and clean.h.
struct ItkPart {
  VolumePtr (*open)(const Path& path);
  VolumePtr (*open_dicom)(const Path& path, const std::string& series, Progress& progress);
  void (*write)(const Volume& volume, const Path& path, Progress& progress);
  VolumePtr (*denoised)(const VolumePtr& volume, const Denoising& denoising, Progress& progress);
};

/// denoised() where there is something to do, within the part.
VolumePtr itk_denoised(const VolumePtr& volume, const Denoising& denoising, Progress& progress);

/// Of the part "openvdb", as `fieldfab_vdb_volume`.
struct VdbVolumePart {
  VolumePtr (*open)(const Path& path);
};

}  // namespace fieldfab
