// Any bytes as a PNG picture, and as both slices of a volume: an Error, or pixels of the stated
// size.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/render/image.h"
#include "fieldfab/volume/volume_file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_png_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  for (const char* const name : {"1.png", "2.png"})
    write_file(folder / name, {reinterpret_cast<const char*>(data), size});
  const auto checked = [](const auto& attempt) {
    try {
      attempt();
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::internal) std::abort();
    }
  };
  checked([&] {
    const Image image = read_png(folder / "1.png");
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.pixels8.size() + image.pixels16.size() != pixels * static_cast<std::size_t>(image.channels)) std::abort();
  });
  checked([&] {
    const VolumePtr volume = open_volume(folder);
    if (volume->lattice().count() < 10'000'000) (void)read_all(*volume);
  });
  return 0;
}
