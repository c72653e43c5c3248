// Any bytes as a saved stock, with a valid checksum: an Error, or a stock that can be cut and
// drawn, and that is saved as the same bytes.
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace {

using namespace fieldfab;

/// A file that contains the bytes of a stock.
std::string file_of(const std::string& raw) {
  uLongf size = compressBound(raw.size());
  std::string body(size, '\0');
  compress2(reinterpret_cast<Bytef*>(body.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size(), 1);
  body.resize(size);
  const std::uint64_t unpacked = raw.size();
  const std::string sized = std::string(reinterpret_cast<const char*>(&unpacked), 8) + body;
  const std::array<std::uint32_t, 2> numbers{
      1, static_cast<std::uint32_t>(
             crc32(0, reinterpret_cast<const Bytef*>(sized.data()), static_cast<uInt>(sized.size())))};
  return "FFSTOCK\n" + std::string(reinterpret_cast<const char*>(numbers.data()), 8) + sized;
}

void cut(cam::Stock& stock) {
  cam::Tool tool;
  tool.diameter = 0.3 * stock.lattice().box().size().minCoeff(), tool.flute = 10 * tool.diameter;
  const cam::ToolSolid solid = cam::tool_solid(tool);
  const Vec3 middle = stock.lattice().box().centre();
  const cam::Stroke stroke{
      &solid.pieces[0], {stock.lattice().box().lower, Vec3::UnitZ()}, {middle, Vec3::UnitZ()}, 7, true};
  stock.cut({&stroke, 1});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fuzz_stock_" + std::to_string(::getpid()) + ".fieldstock");
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  write_file(path, data[0] % 2 == 0 ? text : file_of(text));
  try {
    cam::Stock stock = cam::read_stock(path);
    cam::write_stock(stock, path);
    const std::string once = read_file(path);
    cam::write_stock(cam::read_stock(path), path);
    if (read_file(path) != once) std::abort();
    if (stock.statistics().bytes > 1'000'000) return 0;
    cut(stock);
    (void)stock.mesh();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
