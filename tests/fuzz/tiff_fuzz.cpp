// Any bytes as both slices of a folder, and as a .tif file of several pages: an Error, or a volume
// that can be read.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/volume/volume_file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_tiff_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  write_file(folder / "1.tif", bytes);
  write_file(folder / "2.tif", bytes);
  for (const auto& path : {folder, folder / "1.tif"}) try {
      const VolumePtr volume = open_volume(path);
      const SampleLattice& lattice = volume->lattice();
      // a small file may state a large size; slices are read on demand only
      if (lattice.count() > 1'000'000) continue;
      std::vector<float> densities(lattice.count());
      volume->read(0, lattice.size[2], densities.data());
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::internal) std::abort();
    }
  return 0;
}
