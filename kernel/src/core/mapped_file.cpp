#include "fieldfab/core/mapped_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fieldfab/core/error.h"

namespace fieldfab {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    const int why = errno;
    if (descriptor >= 0) ::close(descriptor);
    throw Error(ErrorKind::io, path.string(), fmt::format("cannot read: {}", std::strerror(why)));
  }
  if (S_ISDIR(status.st_mode)) {
    ::close(descriptor);
    throw Error(ErrorKind::io, path.string(), "is a folder, not a file");
  }
  size_ = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  if (size_ > 0) bytes_ = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor, 0);
  const int why = errno;
  ::close(descriptor);
  if (bytes_ == MAP_FAILED) throw Error(ErrorKind::io, path.string(), fmt::format("cannot map: {}", std::strerror(why)));
}

MappedFile::~MappedFile() {
  if (size_ > 0) ::munmap(bytes_, size_);
}

}  // namespace fieldfab
