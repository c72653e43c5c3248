// Any text as a job, and as a machine's data file: an Error, or a job that can be planned.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "fieldfab/cam/job/job.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path folder = [] {
    const auto made = std::filesystem::temp_directory_path() / ("fuzz_job_" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    write_file(made / "part.frep", "max(abs(x)-9, max(abs(y)-7, abs(z)-2))");
    return made;
  }();
  const std::string text(reinterpret_cast<const char*>(data), size);
  // infinite files
  if (text.find("/dev") != std::string::npos || text.find("/proc") != std::string::npos) return 0;
  const auto checked = [](const auto& attempt) {
    try {
      attempt();
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::internal) std::abort();
    }
  };
  checked([&] { (void)cam::read_machine(text, "machine.toml"); });
  write_file(folder / "job.toml", text);
  checked([&] { (void)cam::Job::read(folder / "job.toml").plan(); });
  return 0;
}
