/// Volumes from files, as scanners and laboratories write them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// What a file does not tell by itself, or tells wrongly.
struct VolumeFileOptions {
  std::optional<std::array<int, 3>> size;  ///< of .raw and .vol files; otherwise from their name or their .vgi file
  std::optional<SampleType> type;          ///< of .raw and .vol files; otherwise from their name or size
  std::optional<bool> big_endian;          ///< of .raw and .vol files; little-endian where the name does not tell
  std::optional<std::uint64_t> skip;       ///< bytes of header of .raw and .vol files
  std::optional<Vec3> spacing;             ///< mm; overrides what the file says
  std::string series;                      ///< of a DICOM folder with several: the identifier, a part of it, or its number from 1
};

/// Opens a volume. Raw files, TIFF and PNG stacks and DICOM series are read slice by slice when they are asked for;
/// the rest comes through ITK or OpenVDB into memory. Places are as in the file: for NIfTI and DICOM in LPS coordinates (x to the
/// left, y to the back, z up), as ITK has them. Throws io, bad_input or too_large with one line that says what is wrong.
VolumePtr open_volume(const std::filesystem::path& path, const VolumeFileOptions& options = {},
                      Progress& progress = Progress::none());

/// Writes a volume as .nrrd, .mha, .nii or .nii.gz (through ITK, 32-bit floats) or .raw. Throws io, bad_input.
void write_volume(const Volume& volume, const std::filesystem::path& path, Progress& progress = Progress::none());

}  // namespace fieldfab
