/// Noise reduction and removal of small components.
#pragma once

#include <optional>
#include <string_view>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// A smoothing filter for densities, by ITK.
struct Denoising {
  enum class Kind { none, median, gaussian, anisotropic } kind = Kind::none;
  double amount = 1;  ///< median: radius in samples; gaussian: standard deviation in mm; anisotropic: conductance
  /// Parses "none", "median", "gaussian:0.8" and the like. Throws Error(bad_input).
  static Denoising parse(std::string_view text);
};

/// Parameters of noise reduction and of removal of small components.
struct CleanSettings {
  Denoising denoise;
  bool keep_largest = false;           ///< keep only the largest component of the solid
  std::optional<double> least_island;  ///< smaller components are removed, mm^3
  std::optional<double> least_hole;    ///< smaller cavities are filled, mm^3; infinity fills all
};

/// Returns the filtered volume, or `volume` itself without a filter. Works in memory, with about 12 bytes per sample.
/// Throws Error(too_large), Error(cancelled).
VolumePtr denoised(VolumePtr volume, const Denoising& denoising, Progress& progress = Progress::none());

/// Returns the volume without small components and cavities of the solid at `threshold`; `below` states that the solid
/// has the lower densities. Removed samples get their density mirrored at the threshold. Components are connected
/// through faces of samples. Works in memory. Throws Error(too_large), Error(cancelled).
VolumePtr cleaned(VolumePtr volume, double threshold, bool below, const CleanSettings& settings,
                  Progress& progress = Progress::none());

}  // namespace fieldfab
