#include "fieldfab/volume/scan.h"

#include <fmt/format.h>

#include "fieldfab/core/error.h"

namespace fieldfab {

Scan take_scan(VolumePtr volume, const ScanOptions& options, Progress& progress) {
  if (const auto& crop = options.crop)
    volume = cropped(std::move(volume), {(*crop)[0], (*crop)[1], (*crop)[2]},
                     {(*crop)[3] - (*crop)[0] + 1, (*crop)[4] - (*crop)[1] + 1, (*crop)[5] - (*crop)[2] + 1});
  volume = denoised(std::move(volume), options.clean.denoise, progress);
  const double threshold = threshold_by(options.threshold, *volume, options.memory, progress);
  volume = cleaned(std::move(volume), threshold, options.below, options.clean, progress);
  return {volume, isosurface(*volume, threshold, options.below)};
}

Scan open_scan(const std::filesystem::path& path, const ScanOptions& options, Progress& progress) {
  try {
    return take_scan(open_volume(path, options.file, progress), options, progress);
  } catch (const Error& error) {
    if (error.place() != "volume") throw;
    const std::string message = error.what();  // names the file instead of the volume
    throw Error(error.kind(), path.string(), message.substr(message.find(": ") + 2));
  }
}

}  // namespace fieldfab
