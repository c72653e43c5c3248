#include "fieldfab/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <utility>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

constexpr std::size_t longest_stem = 128;  // in the name of a temporary file, which is six characters longer

[[noreturn]] void fail(const std::filesystem::path& path, const char* action) {
  throw Error(ErrorKind::io, path.string(), fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// A second name of a file, removed at the end, from which the file is put back after it was replaced.
class KeptFile {
 public:
  /// Does nothing if there is no file. Throws Error(io) about `name`.
  KeptFile(const std::filesystem::path& name, const std::filesystem::path& file, std::filesystem::path kept)
      : file_(file), kept_(std::move(kept)) {
    // Some file systems have no hard links.
    exists_ = ::link(file_.c_str(), kept_.c_str()) == 0 || ::rename(file_.c_str(), kept_.c_str()) == 0;
    if (!exists_ && errno != ENOENT) fail(name, "write");
  }
  ~KeptFile() {
    if (exists_) ::unlink(kept_.c_str());
  }
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;
  void put_back() const noexcept {
    if (exists_)
      ::rename(kept_.c_str(), file_.c_str());
    else
      ::unlink(file_.c_str());
  }

 private:
  std::filesystem::path file_, kept_;
  bool exists_ = false;
};

/// Returns a description of a file that is not a regular one; null for a regular file.
const char* other_kind(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFDIR: return "is a folder, not a file";
    case S_IFIFO: return "is a pipe, not a file";
    case S_IFSOCK: return "is a socket, not a file";
    case S_IFCHR:
    case S_IFBLK: return "is a device, not a file";
    default: return nullptr;
  }
}

/// Whether the file is an anonymous pipe, inherited from the parent process.
bool is_inherited_pipe(int descriptor, const struct stat& status) {
  constexpr decltype(std::declval<struct statfs>().f_type) pipe_system = 0x50495045;  // PIPEFS_MAGIC
  struct statfs system {};
  return S_ISFIFO(status.st_mode) && ::fstatfs(descriptor, &system) == 0 && system.f_type == pipe_system;
}

/// Returns the end of a file name by which libraries recognise its format, such as ".nii.gz".
std::string suffix_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".gz" ? path.stem().extension().string() + extension : extension;
}

/// Whether a failed fsync() means only that the file system does not support it.
bool has_no_sync() { return errno == EINVAL || errno == ENOTSUP || errno == EROFS; }

}  // namespace

void require_regular_file(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) throw Error(ErrorKind::io, path.string(), "there is no such file");
    fail(path, "read");
  }
  if (const char* const kind = other_kind(status.st_mode)) throw Error(ErrorKind::io, path.string(), kind);
}

std::string read_file(const std::filesystem::path& path, std::uintmax_t limit) {
  // Without O_NONBLOCK the open() of a named pipe waits for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (file.number() < 0 && errno == ENXIO) throw Error(ErrorKind::io, path.string(), other_kind(S_IFSOCK));
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) fail(path, "read");
  if (const char* const kind = other_kind(status.st_mode); kind != nullptr && !is_inherited_pipe(file.number(), status))
    throw Error(ErrorKind::io, path.string(), kind);
  if (::fcntl(file.number(), F_SETFL, 0) != 0) fail(path, "read");  // blocking again
  std::string bytes;
  const auto expected = static_cast<std::uintmax_t>(std::max<off_t>(status.st_size, 0));
  if (expected > limit) throw Error(ErrorKind::too_large, path.string(), fmt::format("is larger than {} bytes", limit));
  bytes.reserve(static_cast<std::size_t>(expected));
  // Reads up to the end, not up to the size reported, so that pipes and files in /proc work as
  // well.
  for (std::string chunk(std::size_t{1} << 16, '\0');;) {
    const ssize_t got = ::read(file.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "read");
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (bytes.size() > limit)
      throw Error(ErrorKind::too_large, path.string(), fmt::format("is larger than {} bytes", limit));
  }
}

PendingFile::PendingFile(std::filesystem::path target) : name_(std::move(target)), target_(name_) {
  struct stat old {};
  const bool exists = ::stat(target_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) throw Error(ErrorKind::io, name_.string(), "cannot write: is a folder");
  // A target that is a link stays one: the file it points to is replaced.
  std::error_code ignored;
  if (std::filesystem::is_symlink(target_, ignored)) target_ = std::filesystem::weakly_canonical(target_, ignored);
  // Only a regular file can be replaced. The bytes for a device or a pipe are collected in a
  // temporary file, since libraries that open it by name would not report that it is full, and seek
  // back during writing.
  device_ = exists && !S_ISREG(old.st_mode);
  const std::string suffix = suffix_of(name_);
  std::string stem = name_.filename().string();
  stem.resize(std::min(stem.size() - suffix.size(), longest_stem));
  const std::filesystem::path folder = device_ ? std::filesystem::temp_directory_path() : target_.parent_path();
  std::string pattern = (folder / fmt::format(".{}.XXXXXX{}", stem, suffix)).string();
  descriptor_ = ::mkostemps(pattern.data(), static_cast<int>(suffix.size()), O_CLOEXEC);
  if (descriptor_ < 0) fail();
  Descriptor guard(descriptor_);  // until the destructor takes over
  temporary_.emplace(std::move(pattern));
  buffer_.reserve(buffer_size);
  guard.release();
}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void PendingFile::fail() const { fieldfab::fail(name_, "write"); }

void PendingFile::write_all(int descriptor, const char* data, std::size_t size) const {
  while (size > 0) {
    const ssize_t done = ::write(descriptor, data, size);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail();
    data += done;
    size -= static_cast<std::size_t>(done);
  }
}

void PendingFile::flush() {
  write_all(descriptor_, buffer_.data(), buffer_.size());
  buffer_.clear();
}

void PendingFile::write(const void* data, std::size_t size) {
  if (buffer_.size() + size > buffer_size) flush();
  if (size >= buffer_size)
    write_all(descriptor_, static_cast<const char*>(data), size);
  else
    buffer_.append(static_cast<const char*>(data), size);
}

void PendingFile::rewrite(std::uint64_t offset, const void* data, std::size_t size) {
  flush();
  for (const char* at = static_cast<const char*>(data); size > 0;) {
    const ssize_t done = ::pwrite(descriptor_, at, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail();
    at += done, offset += static_cast<std::uint64_t>(done), size -= static_cast<std::size_t>(done);
  }
}

void PendingFile::require_room(std::uintmax_t size) const {
  struct stat status {};
  if (size == 0 || ::fstat(descriptor_, &status) != 0) return;
  if (::fallocate(descriptor_, 0, 0, static_cast<off_t>(size)) != 0) {
    if (errno != EOPNOTSUPP && errno != EINTR) fail();
  } else if (::ftruncate(descriptor_, status.st_size) != 0) {  // releases the space again
    fail();
  }
}

void PendingFile::refuse_partial(std::uintmax_t size) const {
  require_room(size);
  throw Error(ErrorKind::io, name_.string(), "cannot write: not all of it is there when it is read again");
}

void PendingFile::complete() {
  flush();
  struct stat ours {
  }, named{}, old{};
  if (::fstat(descriptor_, &ours) != 0 || ::stat(temporary().c_str(), &named) != 0) fail();
  if (ours.st_ino != named.st_ino || ours.st_dev != named.st_dev) {  // a library has put its own file there
    Descriptor other(::open(temporary().c_str(), O_RDWR | O_CLOEXEC));
    if (other.number() < 0) fail();
    ::close(std::exchange(descriptor_, other.release()));
  }
  if (device_) return;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = ::stat(target_.c_str(), &old) == 0 ? (old.st_mode & 07777) : (0666 & ~mask);
  if (::fchmod(descriptor_, mode) != 0 || ::fsync(descriptor_) != 0) fail();
}

void PendingFile::put_in_place() {
  if (device_) return copy_to_device();
  if (::rename(temporary().c_str(), target_.c_str()) != 0) fail();
  temporary_->release();
}

void PendingFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
}

void PendingFile::commit() {
  complete();
  put_in_place();
  sync_folder();
  close();
}

void commit_both(PendingFile& first, PendingFile& second) {
  if (first.device_) {  // what it gets cannot be taken back
    second.commit();
    return first.commit();
  }
  first.complete();
  second.complete();
  const KeptFile old(first.name_, first.target_, first.temporary().string() + ".old");
  try {
    first.put_in_place();
    second.put_in_place();
  } catch (...) {
    old.put_back();
    throw;
  }
  first.sync_folder();
  second.sync_folder();
  first.close();
  second.close();
}

void PendingFile::copy_to_device() {
  Descriptor device(::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
  if (device.number() < 0) fail();
  std::string bytes(buffer_size, '\0');
  for (off_t at = 0;;) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), at);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail();
    if (got == 0) break;
    write_all(device.number(), bytes.data(), static_cast<std::size_t>(got));
    at += got;
  }
  if (::fsync(device.number()) != 0 && !has_no_sync()) fail();
  if (::close(device.release()) != 0) fail();
}

void PendingFile::sync_folder() const {
  if (device_) return;
  const std::filesystem::path folder = target_.parent_path();
  const Descriptor opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() < 0 && errno == EACCES) return;  // a folder may be writable but not readable
  if (opened.number() < 0 || (::fsync(opened.number()) != 0 && !has_no_sync())) fail();
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  PendingFile file(path);
  file.write(bytes);
  file.commit();
}

std::uintmax_t available_memory() {
  std::uintmax_t available = std::uintmax_t{1} << 62;
  std::ifstream meminfo("/proc/meminfo");
  for (std::string name; meminfo >> name;) {
    std::uintmax_t kilobytes = 0;
    if (meminfo >> kilobytes; name == "MemAvailable:") available = kilobytes * 1024;
    meminfo.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  std::ifstream limit_file("/sys/fs/cgroup/memory.max"), used_file("/sys/fs/cgroup/memory.current");
  std::uintmax_t limit = 0, used = 0;
  if (limit_file >> limit && used_file >> used) available = std::min(available, limit > used ? limit - used : 0);
  return available;
}

void require_memory(std::uintmax_t bytes, const std::string& what) {
  const std::uintmax_t available = available_memory();
  if (bytes > available / 10 * 9)
    throw Error(ErrorKind::too_large, "",
                fmt::format("{} would need {:.1f} GB of memory, {:.1f} GB are free", what,
                            static_cast<double>(bytes) / 1e9, static_cast<double>(available) / 1e9));
}

}  // namespace fieldfab
