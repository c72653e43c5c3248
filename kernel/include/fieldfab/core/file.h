/// Reading of whole files, and atomic writing: a file is written completely or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fieldfab/core/temporary.h"

namespace fieldfab {

/// Throws Error(io) unless `path` is a regular file (symbolic links are followed). Libraries that open files by name
/// would block on a named pipe and never reach the end of a device.
void require_regular_file(const std::filesystem::path& path);

/// Returns the content of a regular file or of an inherited pipe (/dev/fd/N). Named pipes, devices, sockets and folders
/// are refused. Throws Error(io) if the file cannot be read, Error(too_large) if it has more than `limit` bytes
/// (default: 4 GiB).
std::string read_file(const std::filesystem::path& path, std::uintmax_t limit = std::uintmax_t{1} << 32);

/// A file under construction. It is written to a temporary file beside the target; commit() renames it onto the target.
/// The destructor removes the temporary file if commit() was not called. An existing target is therefore replaced
/// completely or left unchanged, even after a full disk, a crash or a power failure. If the target is a device or a
/// pipe, commit() copies the finished file to it.
class PendingFile {
 public:
  /// Creates the temporary file in the target's folder, or in the system's temporary folder for a device or a pipe. A
  /// symbolic link is followed. Throws Error(io) if the file cannot be created or the target is a folder.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Appends `size` bytes. Throws Error(io), for example on a full disk.
  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Overwrites `size` bytes from `offset` on, for headers with counts that are known last. Throws Error(io).
  void rewrite(std::uint64_t offset, const void* data, std::size_t size);
  /// Path of the temporary file, for libraries that open files by name. It has the extension of the target. The caller
  /// must check that the library wrote the whole file; see refuse_partial().
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_->path(); }
  /// Throws Error(io) if `size` bytes exceed the free space or the file size limit. Does nothing on file systems
  /// without fallocate().
  void require_room(std::uintmax_t size) const;
  /// Throws Error(io) after a library wrote less than the expected `size` bytes. The message names a full disk if
  /// require_room() detects one.
  [[noreturn]] void refuse_partial(std::uintmax_t size) const;
  /// Flushes and syncs the file, renames it onto the target and syncs the folder. Keeps the permissions of an existing
  /// target. Throws Error(io). The target is then unchanged, unless it is a device or a pipe, or only the sync of the
  /// folder failed.
  void commit();
  friend void commit_both(PendingFile& first, PendingFile& second);

 private:
  [[noreturn]] void fail() const;
  void flush();
  void complete();      ///< flushes and syncs
  void put_in_place();  ///< after complete()
  void close();
  void write_all(int descriptor, const char* data, std::size_t size) const;
  void copy_to_device();
  void sync_folder() const;
  std::filesystem::path name_, target_;  ///< the path as given; the path after symbolic links
  std::optional<Temporary> temporary_;
  std::string buffer_;
  bool device_ = false;  ///< whether the target is a device or a pipe
  int descriptor_ = -1;
};

/// Commits two files that belong together. Throws Error(io). Both targets are then unchanged, except as in commit(); a
/// `first` that was replaced is put back. A process that is killed between the two renames leaves a new `first`.
void commit_both(PendingFile& first, PendingFile& second);

/// Writes `bytes` to `path`, completely or not at all. Throws Error(io).
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Returns the memory that this process can still allocate, in bytes: the lesser of MemAvailable (/proc/meminfo) and
/// the rest of the cgroup's limit. Returns 2^62 if the system reports neither.
std::uintmax_t available_memory();

/// Throws Error(too_large) if `bytes` exceeds nine tenths of available_memory(). `what` is the subject of the message.
void require_memory(std::uintmax_t bytes, const std::string& what);

}  // namespace fieldfab
