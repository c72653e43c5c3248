/// Zip archives for .3mf files: written as a stream, read from memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/core/file.h"

namespace fieldfab {

/// A block of a part, deflated on its own, so that blocks can be made in parallel.
struct Deflated {
  std::string bytes;
  std::uint64_t size = 0;  ///< before compression
  std::uint32_t crc = 0;   ///< of the uncompressed bytes
};
Deflated deflated(std::string_view text);

/// Writes an archive from front to back. No byte is written twice, so pipes are possible, and
/// memory use is constant; libzip has neither property. The same parts give the same bytes: dates
/// are 1 January 1980. Throws io.
class ZipWriter {
 public:
  explicit ZipWriter(PendingFile& file) : file_(file) {}
  /// Begins a part of at most `most` bytes; its sizes take 64 bits if they may need them.
  void begin(std::string name, std::uint64_t most);
  void add(const Deflated& stretch);
  void end();
  /// Writes a short part.
  void add_part(std::string name, std::string_view text);
  /// Writes the directory of parts; must be the last call.
  void finish();

 private:
  struct Part {
    std::string name;
    bool large = false;  ///< sizes and offset have 64 bits
    std::uint32_t crc = 0;
    std::uint64_t place = 0, size = 0, deflated = 0;
  };
  void write(std::string_view bytes);

  PendingFile& file_;
  std::uint64_t written_ = 0;
  std::vector<Part> parts_;
};

/// An archive in memory, whose content may be wrong or hostile: parts are limited in size, and
/// their checksums are verified.
class ZipReader {
 public:
  /// `bytes` must outlive the object; `path` is for messages. Throws bad_input if it is not an
  /// archive.
  ZipReader(std::string_view bytes, const std::filesystem::path& path);
  ~ZipReader();
  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;

  /// Whether a part of that name exists; names are case-insensitive, as in OPC packages.
  [[nodiscard]] bool has(const std::string& name) const;
  /// Calls take() with the bytes of a part, in blocks of at most 256 KiB. Throws bad_input if the
  /// part is missing, damaged, encrypted or compressed by an unknown method; too_large if all reads
  /// of the archive would inflate to more than 64 GiB, or to more than 64 MiB and more than 200
  /// times the archive; and the exceptions of take().
  void read(const std::string& name, const std::function<void(std::string_view)>& take) const;

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

}  // namespace fieldfab
