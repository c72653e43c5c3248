/// A file as memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace fieldfab {

/// A file's bytes without reading them: pages come and go as they are used. Something that is no regular file has none.
class MappedFile {
 public:
  /// Throws Error(io) where the file cannot be opened.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(bytes_), size_}; }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace fieldfab
