/// Memory-mapped files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace fieldfab {

/// The read-only bytes of a regular file, mapped into memory. The system loads pages on access and may drop them.
class MappedFile {
 public:
  /// Maps the file. Throws Error(io) if it cannot be opened or is not a regular file.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// The content; empty for an empty file. Valid as long as this object.
  [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(bytes_), size_}; }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace fieldfab
