#include "fieldfab/core/mapped_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab {

MappedFile::MappedFile(const std::filesystem::path& path) {
  require_regular_file(path);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    const int why = errno;
    if (descriptor >= 0) ::close(descriptor);
    throw Error(ErrorKind::io, path.string(), fmt::format("cannot read: {}", std::strerror(why)));
  }
  size_ = static_cast<std::size_t>(status.st_size);
  if (size_ > 0) bytes_ = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor, 0);
  const int why = errno;
  ::close(descriptor);
  if (bytes_ == MAP_FAILED)
    throw Error(ErrorKind::io, path.string(), fmt::format("cannot map: {}", std::strerror(why)));
}

MappedFile::~MappedFile() {
  if (size_ > 0) ::munmap(bytes_, size_);
}

}  // namespace fieldfab
