#include <zlib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "fieldfab/core/error.h"
#include "zip_archive.h"

namespace fieldfab {
namespace {

constexpr std::uint64_t most_in_32_bits = 0xfffffffe;  // the next number announces 64 bits
constexpr std::uint16_t date = 1 << 5 | 1;             // 1 January 1980, the first possible date
constexpr std::uint16_t sizes_follow_the_data = 1 << 3;
constexpr std::uint16_t deflate_method = 8;

/// Numbers of a header, little-endian.
class Header {
 public:
  Header& u16(std::uint64_t value) { return little(value, 2); }
  Header& u32(std::uint64_t value) { return little(value, 4); }
  Header& u64(std::uint64_t value) { return little(value, 8); }
  Header& text(std::string_view words) {
    bytes_ += words;
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  Header& little(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(value >> 8 * i & 0xff);
    return *this;
  }
  std::string bytes_;
};

std::uint64_t version_for(bool large) { return large ? 45 : 20; }

}  // namespace

Deflated deflated(std::string_view text) {
  // zlib's default level, 6, takes 1.6 times as long for text of meshes, and saves only 2 %.
  constexpr int level = 4, raw_window = -15, memory = 8;
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, raw_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error(ErrorKind::internal, "zlib", "cannot begin to deflate");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, deflateEnd);
  Deflated result;
  constexpr std::size_t flush = 16;  // bytes of the flush beyond zlib's own bound
  result.bytes = std::string(deflateBound(&stream, static_cast<uLong>(text.size())) + flush, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.bytes.data());
  stream.avail_out = static_cast<uInt>(result.bytes.size());
  // A flush ends on a whole byte and leaves the stream open, so that blocks can be joined.
  if (deflate(&stream, Z_SYNC_FLUSH) != Z_OK || stream.avail_in != 0 || stream.avail_out == 0)
    throw Error(ErrorKind::internal, "zlib", "cannot deflate");
  result.bytes.erase(result.bytes.size() - stream.avail_out);
  result.size = text.size();
  result.crc = static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
  return result;
}

void ZipWriter::write(std::string_view bytes) {
  file_.write(bytes);
  written_ += bytes.size();
}

void ZipWriter::begin(std::string name, std::uint64_t most) {
  Part part;
  part.name = std::move(name);
  part.large = std::max(most + most / 64 + 64, written_) > most_in_32_bits;  // incompressible bytes grow slightly
  part.place = written_;
  const std::uint64_t size = part.large ? 0xffffffff : 0;
  Header header;
  header.u32(0x04034b50).u16(version_for(part.large)).u16(sizes_follow_the_data).u16(deflate_method).u16(0).u16(date);
  header.u32(0).u32(size).u32(size).u16(part.name.size()).u16(part.large ? 20 : 0).text(part.name);
  if (part.large) header.u16(1).u16(16).u64(0).u64(0);
  write(header.bytes());
  parts_.push_back(std::move(part));
}

void ZipWriter::add(const Deflated& stretch) {
  Part& part = parts_.back();
  part.crc = static_cast<std::uint32_t>(crc32_combine(part.crc, stretch.crc, static_cast<z_off_t>(stretch.size)));
  part.size += stretch.size;
  part.deflated += stretch.bytes.size();
  write(stretch.bytes);
}

void ZipWriter::end() {
  Part& part = parts_.back();
  constexpr std::string_view last_block("\x03\x00", 2);  // empty, with the mark of the last block
  part.deflated += last_block.size();
  write(last_block);
  Header header;
  header.u32(0x08074b50).u32(part.crc);
  if (part.large)
    header.u64(part.deflated).u64(part.size);
  else
    header.u32(part.deflated).u32(part.size);
  write(header.bytes());
}

void ZipWriter::add_part(std::string name, std::string_view text) {
  begin(std::move(name), text.size());
  add(deflated(text));
  end();
}

void ZipWriter::finish() {
  const std::uint64_t start = written_;
  for (const Part& part : parts_) {
    const auto narrow = [&](std::uint64_t number) { return part.large ? 0xffffffff : number; };
    Header header;
    header.u32(0x02014b50).u16(version_for(part.large)).u16(version_for(part.large)).u16(sizes_follow_the_data);
    header.u16(deflate_method).u16(0).u16(date).u32(part.crc).u32(narrow(part.deflated)).u32(narrow(part.size));
    header.u16(part.name.size())
        .u16(part.large ? 28 : 0)
        .u16(0)
        .u16(0)
        .u16(0)
        .u32(0)
        .u32(narrow(part.place))
        .text(part.name);
    if (part.large) header.u16(1).u16(24).u64(part.size).u64(part.deflated).u64(part.place);
    write(header.bytes());
  }
  const std::uint64_t end = written_, size = end - start, count = parts_.size();
  Header header;
  const bool large = end > most_in_32_bits;
  if (large) {
    header.u32(0x06064b50).u64(44).u16(version_for(true)).u16(version_for(true)).u32(0).u32(0);
    header.u64(count).u64(count).u64(size).u64(start);
    header.u32(0x07064b50).u32(0).u64(end).u32(1);
  }
  header.u32(0x06054b50)
      .u16(0)
      .u16(0)
      .u16(count)
      .u16(count)
      .u32(large ? 0xffffffff : size)
      .u32(large ? 0xffffffff : start)
      .u16(0);
  write(header.bytes());
}

}  // namespace fieldfab
