#include "fieldfab/core/temporary.h"

#include <chrono>
#include <mutex>
#include <utility>

namespace fieldfab {
namespace {

std::timed_mutex& list_mutex() {
  static auto& mutex = *new std::timed_mutex;  // never destroyed: threads may outlive main()
  return mutex;
}
Temporary* first = nullptr;

}  // namespace

Temporary::Temporary(std::filesystem::path path) : path_(std::move(path)), listed_(true) {
  const std::lock_guard lock(list_mutex());
  next_ = std::exchange(first, this);
  if (next_ != nullptr) next_->before_ = this;
}

Temporary::~Temporary() {
  if (listed_) remove();
  release();
}

void Temporary::release() noexcept {
  const std::lock_guard lock(list_mutex());
  if (!std::exchange(listed_, false)) return;
  (before_ != nullptr ? before_->next_ : first) = next_;
  if (next_ != nullptr) next_->before_ = before_;
}

void Temporary::remove() const noexcept {
  std::error_code ignored;
  try {
    std::filesystem::remove_all(path_, ignored);
  } catch (...) {  // no memory for the names in a folder
  }
}

void remove_temporaries() noexcept {
  // A thread that was stopped while it had the lock must not hold up the end.
  const std::unique_lock lock(list_mutex(), std::chrono::milliseconds(50));
  for (const Temporary* here = first; here != nullptr; here = here->next_) here->remove();
}

}  // namespace fieldfab
