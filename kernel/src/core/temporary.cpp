#include "fieldfab/core/temporary.h"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <mutex>
#include <string_view>
#include <utility>

namespace fieldfab {
namespace {

constinit std::mutex list_mutex;  // needs no memory, and exists until the end of the process
constinit Temporary* first = nullptr;

/// Removes a file, or a folder and all below it. Allocates nothing: memory may be what the process ends for.
void remove_at(int folder, const char* name) noexcept {
  if (::unlinkat(folder, name, 0) == 0 || errno != EISDIR) return;
  const int opened = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (opened < 0) return;
  alignas(dirent64) std::array<char, 4096> entries;
  for (ssize_t size = 0; (size = ::getdents64(opened, entries.data(), entries.size())) > 0;)
    for (ssize_t at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      at += entry->d_reclen;
      const std::string_view found = entry->d_name;
      if (found != "." && found != "..") remove_at(opened, entry->d_name);
    }
  ::close(opened);
  ::unlinkat(folder, name, AT_REMOVEDIR);
}

}  // namespace

Temporary::Temporary(std::filesystem::path path) : path_(std::move(path)), listed_(true) {
  const std::lock_guard lock(list_mutex);
  next_ = std::exchange(first, this);
  if (next_ != nullptr) next_->before_ = this;
}

Temporary::~Temporary() {
  if (listed_) remove();
  release();
}

void Temporary::release() noexcept {
  const std::lock_guard lock(list_mutex);
  if (!std::exchange(listed_, false)) return;
  (before_ != nullptr ? before_->next_ : first) = next_;
  if (next_ != nullptr) next_->before_ = before_;
}

void Temporary::remove() const noexcept { remove_at(AT_FDCWD, path_.c_str()); }

void remove_temporaries() noexcept {
  // A thread that was stopped while it held the lock must not block the end.
  bool locked = list_mutex.try_lock();
  for (int wait = 0; !locked && wait < 50; ++wait) {
    ::usleep(1000);
    locked = list_mutex.try_lock();
  }
  for (const Temporary* here = first; here != nullptr; here = here->next_) here->remove();
  if (locked) list_mutex.unlock();
}

}  // namespace fieldfab
