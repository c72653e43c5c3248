// Any bytes as an .asdf file: an Error, or a distance field that answers. The checksum is set right, so that what is behind it is
// tried too.
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
  if (bytes.size() > 12 && bytes.starts_with("FFASDF1\n")) {
    const auto sum = static_cast<std::uint32_t>(
        crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()) + 12, static_cast<uInt>(bytes.size() - 12)));
    std::memcpy(bytes.data() + 8, &sum, 4);
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
