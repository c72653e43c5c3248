/// The readers behind open_volume(), one a family of formats; private to the volume folder.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fieldfab/core/error.h"
#include "fieldfab/volume/volume_file.h"

namespace fieldfab {

using Path = std::filesystem::path;

[[noreturn]] inline void refuse(const Path& path, const std::string& why) {
  throw Error(ErrorKind::bad_input, path.string(), why);
}

/// How many samples a lattice of that size has. Throws bad_input for less than two an axis, or more than can be counted.
std::size_t sample_count(const std::array<long long, 3>& size, const Path& path);

/// Samples as a file keeps them, `swap`ped where its byte order is the other one, as floats.
void to_floats(SampleType type, const std::byte* from, std::size_t count, bool swap, float* out);

/// A path's extension in lower case.
std::string extension_of(const Path& path);

/// `key = value` lines; keys in lower case, what comes later counts less. Throws as read_file().
std::map<std::string, std::string> read_settings(const Path& path);
/// Three numbers apart by spaces, commas or x; nothing where there are others.
std::optional<std::array<double, 3>> three_numbers(std::string_view text);

/// Samples in a file as they are: a range of it. Throws bad_input where the file is too short or too long for them.
struct RawLayout {
  SampleLattice lattice;
  SampleType type = SampleType::uint8;
  bool big_endian = false;
  std::uint64_t skip = 0;
};
VolumePtr open_samples(const Path& path, const RawLayout& layout);
/// .raw and .vol: by options, by the .vgi file beside, by name.
VolumePtr open_raw(const Path& path, const VolumeFileOptions& options);
/// .vgi: the header that names a .vol file.
VolumePtr open_vgi(const Path& path, const VolumeFileOptions& options);

/// A picture of a stack: its size, and its grey values on request. Each call opens the file anew, so that many may go on at once.
class Slice {
 public:
  virtual ~Slice() = default;
  int width = 0, height = 0;
  SampleType type = SampleType::uint8;
  virtual void read(float* out) const = 0;
};
using SlicePtr = std::unique_ptr<Slice>;
/// Grey as the eye weighs colours (ITU-R BT.601); what is grey already stays the same number.
inline float grey(float red, float green, float blue) {
  return red == green && green == blue ? red : 0.299F * red + 0.587F * green + 0.114F * blue;
}
/// Slices by these files, one after another, read when they are asked for. Throws bad_input where they differ in size or type.
VolumePtr stack_of(std::vector<SlicePtr> slices, const std::vector<Path>& files, SampleLattice lattice);

/// The pages of a TIFF file.
std::vector<SlicePtr> tiff_pages(const Path& path);
SlicePtr png_slice(const Path& path);

/// MetaImage, NRRD and NIfTI, through ITK.
VolumePtr open_with_itk(const Path& path);
/// The DICOM series of a folder, or the file alone; through ITK.
VolumePtr open_dicom(const Path& path, const std::string& series, Progress& progress);
/// Whether a file is DICOM, whatever its name.
bool is_dicom(const Path& path);
void write_with_itk(const Volume& volume, const Path& path, Progress& progress);

/// The first grid of numbers in a .vdb file; the signed distance of a level set is taken as a density below 0.
VolumePtr open_vdb(const Path& path);

}  // namespace fieldfab
