/// Readers behind open_volume(), one per family of formats; private to the volume folder.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fieldfab/core/error.h"
#include "fieldfab/volume/volume_file.h"

namespace fieldfab {

using Path = std::filesystem::path;

[[noreturn]] inline void refuse(const Path& path, const std::string& why) {
  throw Error(ErrorKind::bad_input, path.string(), why);
}

/// Returns the number of samples of a lattice. Throws bad_input for less than two along an axis, or
/// for more than can be counted.
std::size_t sample_count(const std::array<long long, 3>& size, const Path& path);

/// Returns a volume of lattice.count() densities, or more, in memory that it keeps.
VolumePtr volume_in(std::shared_ptr<const float> densities, const SampleLattice& lattice,
                    std::optional<double> own_threshold, SampleType type);

/// Converts samples of a file to floats; `swap` reverses their bytes.
void to_floats(SampleType type, const std::byte* from, std::size_t count, bool swap, float* out);

/// Reads `key = value` lines; keys in lower case, the first of equal keys counts. Throws as
/// read_file().
std::map<std::string, std::string> read_settings(const Path& path);
/// Parses three numbers separated by spaces, commas or x; returns nullopt for anything else.
std::optional<std::array<double, 3>> three_numbers(std::string_view text);

/// Uncompressed samples in a range of a file. open_samples() throws bad_input if the file is too
/// short or too long.
struct RawLayout {
  SampleLattice lattice;
  SampleType type = SampleType::uint8;
  bool big_endian = false;
  std::uint64_t skip = 0;
};
VolumePtr open_samples(const Path& path, const RawLayout& layout);
/// Opens .raw and .vol: by options, by the .vgi file beside it, or by name.
VolumePtr open_raw(const Path& path, const VolumeFileOptions& options);
/// Opens .vgi, the header that names a .vol file.
VolumePtr open_vgi(const Path& path, const VolumeFileOptions& options);

/// An image of a stack: its size, and its grey values on request. Each call opens the file again,
/// so that calls may run in parallel.
class Slice {
 public:
  virtual ~Slice() = default;
  int width = 0, height = 0;
  SampleType type = SampleType::uint8;
  virtual void read(float* out) const = 0;
};
using SlicePtr = std::unique_ptr<Slice>;
/// Luma of a colour (ITU-R BT.601); grey stays the same number.
inline float grey(float red, float green, float blue) {
  return red == green && green == blue ? red : 0.299F * red + 0.587F * green + 0.114F * blue;
}
/// Returns slices of these files as a volume, read on demand. Throws bad_input if they differ in
/// size or type.
VolumePtr stack_of(std::vector<SlicePtr> slices, const std::vector<Path>& files, SampleLattice lattice);

/// Returns the pages of a TIFF file.
std::vector<SlicePtr> tiff_pages(const Path& path);
SlicePtr png_slice(const Path& path);

/// Opens MetaImage, NRRD and NIfTI, through ITK.
VolumePtr open_with_itk(const Path& path, Progress& progress);
/// Opens the DICOM series of a folder, or a single file; through ITK.
VolumePtr open_dicom(const Path& path, const std::string& series, Progress& progress);
/// Whether a file is DICOM, by its content.
bool is_dicom(const Path& path);
void write_with_itk(const Volume& volume, const Path& path, Progress& progress);

/// Opens the first grid of numbers in a .vdb file; the signed distance of a level set becomes a
/// density below 0.
VolumePtr open_vdb(const Path& path, Progress& progress);

}  // namespace fieldfab
