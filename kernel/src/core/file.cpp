#include "fieldfab/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <utility>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

[[noreturn]] void fail(const std::filesystem::path& path, const char* action) {
  throw Error(ErrorKind::io, path.string(), fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

void write_all(int descriptor, const char* data, std::size_t size, const std::filesystem::path& path) {
  while (size > 0) {
    const ssize_t done = ::write(descriptor, data, size);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail(path, "write");
    data += done;
    size -= static_cast<std::size_t>(done);
  }
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uintmax_t limit) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, "read");
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  } closer{descriptor};
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail(path, "read");
  if (S_ISDIR(status.st_mode)) throw Error(ErrorKind::io, path.string(), "is a folder, not a file");
  std::string bytes;
  const auto expected = static_cast<std::uintmax_t>(std::max<off_t>(status.st_size, 0));
  if (expected > limit) throw Error(ErrorKind::too_large, path.string(), fmt::format("is larger than {} bytes", limit));
  bytes.reserve(static_cast<std::size_t>(expected));
  // Read to the end rather than to the size told, so that pipes and files in /proc work as well.
  for (std::string chunk(std::size_t{1} << 16, '\0');;) {
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "read");
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (bytes.size() > limit) throw Error(ErrorKind::too_large, path.string(), fmt::format("is larger than {} bytes", limit));
  }
}

PendingFile::PendingFile(std::filesystem::path target) : target_(std::move(target)) {
  if (std::filesystem::is_directory(target_)) throw Error(ErrorKind::io, target_.string(), "cannot write: is a folder");
  // A target that is a link keeps being one: what it points to is replaced.
  std::error_code ignored;
  if (std::filesystem::is_symlink(target_, ignored)) target_ = std::filesystem::weakly_canonical(target_, ignored);
  // A device or a pipe is written to as it stands; only a regular file can be replaced.
  struct stat old {};
  if (::stat(target_.c_str(), &old) == 0 && !S_ISREG(old.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(target_, "write");
    temporary_ = target_;
    return;
  }
  std::string pattern =
      (target_.parent_path() / fmt::format(".{}.XXXXXX{}", target_.stem().string(), target_.extension().string())).string();
  descriptor_ = ::mkostemps(pattern.data(), static_cast<int>(target_.extension().string().size()), O_CLOEXEC);
  if (descriptor_ < 0) fail(target_, "write");
  temporary_ = pattern;
  buffer_.reserve(buffer_size);
}

PendingFile::~PendingFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (temporary_ != target_) ::unlink(temporary_.c_str());
}

void PendingFile::flush() {
  write_all(descriptor_, buffer_.data(), buffer_.size(), target_);
  buffer_.clear();
}

void PendingFile::write(const void* data, std::size_t size) {
  if (buffer_.size() + size > buffer_size) flush();
  if (size >= buffer_size)
    write_all(descriptor_, static_cast<const char*>(data), size, target_);
  else
    buffer_.append(static_cast<const char*>(data), size);
}

void PendingFile::rewrite(std::uint64_t offset, const void* data, std::size_t size) {
  flush();
  if (::pwrite(descriptor_, data, size, static_cast<off_t>(offset)) != static_cast<ssize_t>(size)) fail(target_, "write");
}

void PendingFile::commit() {
  flush();
  if (temporary_ != target_) replace_target();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(target_, "write");
}

void PendingFile::replace_target() {
  struct stat old {};
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = ::stat(target_.c_str(), &old) == 0 ? (old.st_mode & 07777) : (0666 & ~mask);
  if (::fchmod(descriptor_, mode) != 0 || ::fsync(descriptor_) != 0) fail(target_, "write");
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(target_, "write");
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
                fmt::format("{} would need {:.1f} GB of memory, {:.1f} GB are free", what, static_cast<double>(bytes) / 1e9,
                            static_cast<double>(available) / 1e9));
}

}  // namespace fieldfab
