/// How long work tells its caller where it is, and learns that it should stop.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>

namespace fieldfab {

/// Passed by reference to long work; safe to use from many threads at once.
/// Workers call check() at least every 100 ms; callers call cancel() from any thread or signal handler.
class Progress {
 public:
  /// Called with the fraction done (0 to 1) and what is being done; at most one call at a time, from any worker thread.
  using Listener = std::function<void(double fraction, const std::string& message)>;

  Progress() = default;
  explicit Progress(Listener listener) : listener_(std::move(listener)) {}

  /// Reports `fraction` of the present stage; drops the report where another thread is reporting just now.
  void report(double fraction, const std::string& message);
  /// Asks the work to stop.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  /// Throws Error(cancelled) once cancel() was called.
  void check() const;

  /// A Progress that nobody listens to and nobody cancels, for callers that do not care.
  static Progress& none();

 private:
  Listener listener_;
  std::mutex reporting_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace fieldfab
