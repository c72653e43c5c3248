#include "streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fieldfab/core/error.h"

namespace fieldfab::cli {
namespace {

/// Returns whether all was written; errno has the reason otherwise.
bool write_all(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t done = ::write(descriptor, text.data(), text.size());
    if (done >= 0) {
      text.remove_prefix(static_cast<std::size_t>(done));
    } else if (errno == EAGAIN) {  // a pipe that its reader made non-blocking
      pollfd waiting{descriptor, POLLOUT, 0};
      ::poll(&waiting, 1, -1);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

}  // namespace

void open_closed_streams() noexcept {
  // open() returns the lowest free number.
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDWR);
}

void tell(std::initializer_list<std::string_view> parts) noexcept {
  for (const std::string_view part : parts) write_all(STDERR_FILENO, part);
}

void answer(std::string_view text) {
  if (!write_all(STDOUT_FILENO, text))
    throw Error(ErrorKind::io, "standard output", fmt::format("cannot write: {}", std::strerror(errno)));
}

}  // namespace fieldfab::cli
