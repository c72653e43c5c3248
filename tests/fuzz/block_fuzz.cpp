// Any bytes as the decompressed data of a block of an .asdf file: an Error, or a tree.
#include <cstdlib>
#include <cstring>

#include "asdf/asdf_block.h"
#include "fieldfab/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  if (size < 8) return 0;
  EncodedBlock counts;
  counts.raw_size = static_cast<std::uint32_t>(size - 8);
  counts.cells = data[0] + 256U * data[1];
  counts.leafs = data[2] + 256U * data[3];
  const LatticeRange range{{0, 0, 0}, {1 + data[4] % 64, 1 + data[5] % 64, 1 + data[6] % 64}};
  try {
    const std::string bytes = compressed({reinterpret_cast<const char*>(data) + 8, size - 8});
    if (decode_block(bytes, counts, range, 0.01, "fuzz").cells.size() != counts.cells) std::abort();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) std::abort();
  }
  return 0;
}
