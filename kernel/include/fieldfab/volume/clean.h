/// Less noise, and no crumbs.
#pragma once

#include <optional>
#include <string_view>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// Filters that smooth densities, as in ITK.
struct Denoising {
  enum class Kind { none, median, gaussian, anisotropic } kind = Kind::none;
  double amount = 1;  ///< median: radius in samples; gaussian: sigma in mm; anisotropic: conductance
  /// "median", "gaussian:0.8", ... Throws bad_input.
  static Denoising parse(std::string_view text);
};

/// What to do about noise and crumbs.
struct CleanSettings {
  Denoising denoise;
  bool keep_largest = false;           ///< of the solid only the largest piece
  std::optional<double> least_island;  ///< mm3; smaller pieces go
  std::optional<double> least_hole;    ///< mm3; smaller cavities are filled, all of them where it is infinite
};

/// The volume after the filter: itself where there is none. Holds it in memory (about 12 bytes a sample while it works).
VolumePtr denoised(VolumePtr volume, const Denoising& denoising, Progress& progress = Progress::none());

/// The volume without small pieces and holes of the solid at `threshold`: their densities become the threshold mirrored to the
/// other side. Pieces are joined through faces. Holds the volume in memory.
VolumePtr cleaned(VolumePtr volume, double threshold, bool below, const CleanSettings& settings,
                  Progress& progress = Progress::none());

}  // namespace fieldfab
