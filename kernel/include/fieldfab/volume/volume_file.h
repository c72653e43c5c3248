/// Volume files of CT scanners and laboratories.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// Properties that a file does not state, or states wrongly.
struct VolumeFileOptions {
  /// number of samples of .raw and .vol files; default: from the file name or the .vgi file
  std::optional<std::array<int, 3>> size;
  std::optional<SampleType> type;  ///< sample type of .raw and .vol files; default: from the file name or size
  /// byte order of .raw and .vol files; default: from the file name, otherwise little-endian
  std::optional<bool> big_endian;
  std::optional<std::uint64_t> skip;  ///< length of the header of .raw and .vol files, bytes
  std::optional<Vec3> spacing;        ///< spacing, mm; overrides the file's
  /// series of a DICOM folder with several: its identifier, a part of it, or its number from 1
  std::string series;
};

/// Opens a volume. Raw files, TIFF and PNG stacks and DICOM series are read by slices on demand; other formats are read
/// into memory through ITK or OpenVDB. Positions are those of the file: LPS coordinates for NIfTI and DICOM (x to the
/// left, y to the back, z up), as in ITK. Throws Error(io), Error(bad_input), Error(too_large), each with one line that
/// states the problem.
VolumePtr open_volume(const std::filesystem::path& path, const VolumeFileOptions& options = {},
                      Progress& progress = Progress::none());

/// Writes a volume as .nrrd, .mha, .nii or .nii.gz (through ITK, 32-bit floats) or .raw, completely or not at all.
/// Throws Error(io), Error(bad_input) for another extension, Error(cancelled).
void write_volume(const Volume& volume, const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab
