#include "volume/parts.h"

#include <array>
#include <fstream>

#include "core/module.h"

namespace fieldfab {
namespace {

const ItkPart& itk() {
  static const ItkPart& part = in_part<ItkPart>("itk", "fieldfab_itk");
  return part;
}

}  // namespace

VolumePtr open_with_itk(const Path& path, Progress& progress) { return itk().open(path, progress); }

VolumePtr open_dicom(const Path& path, const std::string& series, Progress& progress) {
  return itk().open_dicom(path, series, progress);
}

bool is_dicom(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 132> start{};
  return file.read(start.data(), start.size()) && std::string_view(start.data() + 128, 4) == "DICM";
}

void write_with_itk(const Volume& volume, const Path& path, Progress& progress) { itk().write(volume, path, progress); }

VolumePtr denoised(VolumePtr volume, const Denoising& denoising, Progress& progress) {
  return denoising.kind == Denoising::Kind::none ? volume : itk().denoised(volume, denoising, progress);
}

VolumePtr open_vdb(const Path& path, Progress& progress) {
  return in_part<VdbVolumePart>("openvdb", "fieldfab_vdb_volume").open(path, progress);
}

}  // namespace fieldfab
