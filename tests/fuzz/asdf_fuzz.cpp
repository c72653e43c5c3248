// Any bytes as an .asdf file: an Error, or a valid distance field. Checksums are corrected, so that
// the code behind them is tested, too.
#include <unistd.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(::getpid()) + ".asdf");
  std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto set_sum = [&](std::size_t at, std::size_t first, std::size_t length) {
    const auto sum = static_cast<std::uint32_t>(
        crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()) + first, static_cast<uInt>(length)));
    std::memcpy(bytes.data() + at, &sum, 4);
  };
  if (bytes.size() > 160 && bytes.starts_with("FFASDF2\n")) {
    std::uint64_t offset = 0, length = 0;
    std::memcpy(&offset, bytes.data() + 128, 8);
    std::memcpy(&length, bytes.data() + 136, 8);
    if (offset <= bytes.size() && length <= bytes.size() - offset) set_sum(152, offset, length);
    set_sum(8, 12, 148);
  }
  write_file(path, bytes);
  try {
    const auto asdf = Asdf::load(path);
    (void)asdf->value(asdf->region().centre());
    (void)asdf->interval(asdf->region());
    (void)asdf->statistics();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
