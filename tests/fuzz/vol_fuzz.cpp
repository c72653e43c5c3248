// Any text as the .vgi header of a small .vol file: an Error, or a volume that can be read.
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
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_vol_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    write_file(made / "a.vol", std::string(64, 'x'));
    return made;
  }();
  write_file(folder / "a.vgi", {reinterpret_cast<const char*>(data), size});
  try {
    const VolumePtr volume = open_volume(folder / "a.vol");
    std::vector<float> densities(volume->lattice().count());
    volume->read(0, volume->lattice().size[2], densities.data());
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
