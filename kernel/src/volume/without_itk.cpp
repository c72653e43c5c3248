// Replaces the files that need ITK or OpenVDB if these cannot be compiled: Debian's ITK does not
// support clang, which builds the fuzzers.
#include "fieldfab/volume/clean.h"
#include "readers.h"

namespace fieldfab {
namespace {

[[noreturn]] void left_out(const Path& path) { refuse(path, "this build was made without ITK and OpenVDB"); }

}  // namespace

VolumePtr open_with_itk(const Path& path, Progress&) { left_out(path); }
VolumePtr open_dicom(const Path& path, const std::string&, Progress&) { left_out(path); }
VolumePtr open_vdb(const Path& path, Progress&) { left_out(path); }
bool is_dicom(const Path&) { return false; }
void write_with_itk(const Volume&, const Path& path, Progress&) { left_out(path); }
VolumePtr denoised(VolumePtr volume, const Denoising& denoising, Progress&) {
  if (denoising.kind != Denoising::Kind::none) left_out("denoise");
  return volume;
}

}  // namespace fieldfab
