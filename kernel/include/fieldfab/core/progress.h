/// How long work tells its caller where it is, and learns that it should stop.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace fieldfab {

/// Passed by reference to long work; safe to use from many threads at once.
/// Workers call check() at least every 100 ms; callers call cancel() from any thread or signal handler.
class Progress {
 public:
  /// Called with the fraction done (0 to 1) and what is being done; at most one call at a time, from any worker thread. It may
  /// call cancel(); so that it can at any moment, it is told the same again where there is nothing new (see check()).
  using Listener = std::function<void(double fraction, const std::string& message)>;

  Progress() = default;
  explicit Progress(Listener listener) : listener_(std::move(listener)) {}

  /// Reports `fraction` of the present stage; drops the report where another thread is reporting just now.
  void report(double fraction, const std::string& message);
  /// Asks the work to stop.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  /// Throws Error(cancelled) once cancel() was called. Tells the listener the last report again, a few times a second.
  void check();

  /// A Progress that nobody listens to and nobody cancels, for callers that do not care.
  static Progress& none();

 private:
  using Clock = std::chrono::steady_clock;
  void tell();

  Listener listener_;
  std::mutex reporting_;  ///< of the two of the last report, and of the listener
  double fraction_ = 0;
  std::string message_;
  std::atomic<Clock::rep> told_{0};  ///< when
  std::atomic<bool> cancelled_{false};
};

}  // namespace fieldfab
