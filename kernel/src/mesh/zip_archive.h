/// Zip archives, which .3mf files are: written as a stream, read from memory.
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

/// A stretch of a part, deflated by itself, so that stretches can be made in parallel.
struct Deflated {
  std::string bytes;
  std::uint64_t size = 0;  ///< before
  std::uint32_t crc = 0;   ///< of what was before
};
Deflated deflated(std::string_view text);

/// Writes an archive from front to back: no byte is written twice, so that pipes take it, and memory does not grow with it.
/// libzip does neither. The same parts make the same bytes: dates are 1 January 1980. Throws io.
class ZipWriter {
 public:
  explicit ZipWriter(PendingFile& file) : file_(file) {}
  /// Begins a part that will have at most `most` bytes; its sizes take 64 bits where they may need them.
  void begin(std::string name, std::uint64_t most);
  void add(const Deflated& stretch);
  void end();
  /// Writes a short part.
  void add_part(std::string name, std::string_view text);
  /// Writes the directory of parts; nothing may follow.
  void finish();

 private:
  struct Part {
    std::string name;
    bool large = false;  ///< sizes and place have 64 bits
    std::uint32_t crc = 0;
    std::uint64_t place = 0, size = 0, deflated = 0;
  };
  void write(std::string_view bytes);

  PendingFile& file_;
  std::uint64_t written_ = 0;
  std::vector<Part> parts_;
};

/// An archive in memory. What it says of itself may be wrong or hostile: parts are limited in size, and checked by their sums.
class ZipReader {
 public:
  /// `bytes` must outlive it; `path` is for messages. Throws bad_input where they are no archive.
  ZipReader(std::string_view bytes, const std::filesystem::path& path);
  ~ZipReader();
  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;

  /// Whether there is a part of that name; upper and lower case are the same, as in OPC packages.
  [[nodiscard]] bool has(const std::string& name) const;
  /// Calls take() with a part's bytes, a stretch of at most 256 KiB after the other. Throws bad_input for a part that is not
  /// there, damaged, encrypted or compressed in a way that is not known; too_large where what is read of the archive would
  /// inflate to more than 64 GiB, or to more than 64 MiB and more than 200 times the archive; what take() throws.
  void read(const std::string& name, const std::function<void(std::string_view)>& take) const;

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

}  // namespace fieldfab
