#include "fieldfab/core/progress.h"

#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab {

namespace {

using Duration = std::chrono::steady_clock::duration;
constexpr Duration patience = std::chrono::milliseconds(50);  // after which the last report is repeated
constexpr double a_percent = 0.01;
constexpr Duration least = std::chrono::milliseconds(5);  // between two reports of a stage

}  // namespace

void Progress::report(double fraction, std::string_view message) {
  if (!listener_) return;
  const std::size_t stage = std::hash<std::string_view>()(message);
  const bool little_new = stage == stage_.load(std::memory_order_relaxed) && fraction < 1 &&
                          std::abs(fraction - fraction_.load(std::memory_order_relaxed)) < a_percent;
  if (little_new && Clock::now().time_since_epoch().count() - told_.load(std::memory_order_relaxed) < least.count())
    return;
  const std::unique_lock lock(reporting_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  stage_.store(stage, std::memory_order_relaxed);
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
