#include "fieldfab/core/progress.h"

#include "fieldfab/core/error.h"

namespace fieldfab {

namespace {

constexpr std::chrono::steady_clock::duration patience = std::chrono::milliseconds(50);  // between two reports

}  // namespace

void Progress::report(double fraction, const std::string& message) {
  if (!listener_) return;
  const std::unique_lock lock(reporting_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  fraction_ = fraction;
  message_ = message;
  tell();
}

void Progress::check() {
  if (listener_ && Clock::now().time_since_epoch().count() - told_.load(std::memory_order_relaxed) > patience.count()) {
    const std::unique_lock lock(reporting_, std::try_to_lock);
    if (lock.owns_lock()) tell();
  }
  if (cancelled()) throw Error(ErrorKind::cancelled, "", "cancelled");
}

void Progress::tell() {
  listener_(fraction_, message_);
  told_.store(Clock::now().time_since_epoch().count(), std::memory_order_relaxed);
}

Progress& Progress::none() {
  static Progress nobody;
  return nobody;
}

}  // namespace fieldfab
