/// Files read whole, and files written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fieldfab/core/temporary.h"

namespace fieldfab {

/// Throws Error(io) unless `path` is a regular file: libraries that open files by name would wait for ever for a named
/// pipe, and read a device for ever.
void require_regular_file(const std::filesystem::path& path);

/// The bytes of a regular file, or of a pipe that this process was given (/dev/fd/N), never of a named one. Throws
/// Error(io) where it cannot be read, Error(too_large) where it is larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::uintmax_t limit = std::uintmax_t{1} << 32);

/// A file in the making: written beside its target, put in its place by commit() in one step, removed without it.
/// So an existing target is replaced whole or left as it was, also on a full disk, a crash or a loss of power.
/// A target that is a device or a pipe is given the bytes of the finished file.
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
  /// Where to write, for libraries that open files by name themselves; its extension is the target's. The caller checks
  /// that the library wrote all of it: see refuse_partial().
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_->path(); }
  /// Throws Error(io) where so many bytes are more than the disk or a limit leaves; some file systems do not tell.
  void require_room(std::uintmax_t size) const;
  /// Throws Error(io) for a library that did not write all of about `size` bytes, with the reason where one can be
  /// found.
  [[noreturn]] void refuse_partial(std::uintmax_t size) const;
  /// Flushes, syncs, renames onto the target and syncs its folder. Throws Error(io).
  void commit();

 private:
  [[noreturn]] void fail() const;
  void flush();
  void write_all(int descriptor, const char* data, std::size_t size) const;
  void copy_to_device();
  void replace_target();
  void sync_folder() const;
  std::filesystem::path name_, target_;  ///< as given; with links followed
  std::optional<Temporary> temporary_;
  std::string buffer_;
  bool device_ = false;  ///< the target cannot be replaced
  int descriptor_ = -1;
};

/// Writes `bytes` to `path`, whole or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Memory this process may still take, in bytes, as the kernel tells (MemAvailable and the cgroup's limit, the lesser).
std::uintmax_t available_memory();

/// Throws Error(too_large) naming `what` where `bytes` is more than nine tenths of available_memory().
void require_memory(std::uintmax_t bytes, const std::string& what);

}  // namespace fieldfab
