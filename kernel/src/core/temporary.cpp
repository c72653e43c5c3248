#include "fieldfab/core/temporary.h"

#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <utility>

namespace fieldfab {
namespace {

constinit std::mutex list_mutex;  // needs no memory, and exists until the end of the process
constinit Temporary* first = nullptr;

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

void Temporary::remove() const noexcept {
  if (::unlink(path_.c_str()) == 0 || errno != EISDIR) return;
  try {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  } catch (...) {  // out of memory while the folder is listed
  }
}

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
