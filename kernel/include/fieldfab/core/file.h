/// Files read whole, and files written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace fieldfab {

/// The bytes of a file. Throws Error(io) where it cannot be read, Error(too_large) where it is larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::uintmax_t limit = std::uintmax_t{1} << 32);

/// A file in the making: written beside its target, put in its place by commit() in one step, removed without it.
/// So an existing target is replaced whole or left as it was, also on a full disk or a crash.
class PendingFile {
 public:
  /// Opens a temporary file in the target's folder. Throws Error(io) where that cannot be written.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Appends bytes; throws Error(io), for instance on a full disk.
  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Overwrites bytes written before, from `offset` on: for headers whose counts are known last.
  void rewrite(std::uint64_t offset, const void* data, std::size_t size);
  /// Where to write, for libraries that open files by name themselves; its extension is the target's.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  /// Flushes, syncs and renames onto the target. Throws Error(io).
  void commit();

 private:
  void flush();
  void replace_target();
  std::filesystem::path target_, temporary_;
  std::string buffer_;
  int descriptor_ = -1;
};

/// Writes `bytes` to `path`, whole or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Memory this process may still take, in bytes, as the kernel tells (MemAvailable and the cgroup's limit, the lesser).
std::uintmax_t available_memory();

/// Throws Error(too_large) naming `what` where `bytes` is more than nine tenths of available_memory().
void require_memory(std::uintmax_t bytes, const std::string& what);

}  // namespace fieldfab
