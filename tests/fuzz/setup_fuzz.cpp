// Any text as a project of CAMotics or as a simulation set-up, selected by the first byte: an
// Error, or a set-up.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/cam/simulate/setup.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_setup_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    write_file(made / "part.frep", "max(abs(x)-9, max(abs(y)-7, abs(z)-2))");
    write_file(made / "a.nc", "G21 G90\nG0 X0 Y0 Z5\nG1 Z-2 F200\nG1 X8\nG2 X0 Y8 I-8\nG0 Z5\nM30\n");
    return made;
  }();
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  // infinite files
  if (text.find("/dev") != std::string::npos || text.find("/proc") != std::string::npos) return 0;
  const auto path = folder / (data[0] % 2 == 0 ? "setup.toml" : "setup.camotics");
  write_file(path, text);
  try {
    const cam::SimulationSetup setup = cam::read_simulation_setup(path);
    if (!setup.stock_box.valid() && !setup.stock) std::abort();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
