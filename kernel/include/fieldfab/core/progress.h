/// Progress reports and cancellation of long computations.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace fieldfab {

/// Connects a long computation with its caller. All members may be called from several threads at the same time. The
/// computation calls check() at least every 100 ms; the caller calls cancel() from any thread or from a signal handler.
class Progress {
 public:
  /// Receives the completed fraction (0 to 1) of the current stage and its description. Called from any worker thread,
  /// one call at a time. It may call cancel(). check() repeats the last report, so that the listener can cancel at any
  /// time.
  using Listener = std::function<void(double fraction, const std::string& message)>;

  Progress() = default;
  explicit Progress(Listener listener) : listener_(std::move(listener)) {}

  /// Reports the completed fraction of the current stage. Cheap: only the first report of a stage, its end, each
  /// percent, and one every few milliseconds reach the listener, and none while another thread is reporting.
  void report(double fraction, std::string_view message);
  /// Requests cancellation. Safe in a signal handler.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  /// Throws Error(cancelled) after cancel(). Repeats the last report to the listener if more than 50 ms have passed
  /// since.
  void check();

  /// Returns a shared Progress without a listener, for callers that need neither reports nor cancellation.
  static Progress& none();

 private:
  using Clock = std::chrono::steady_clock;
  void tell();

  Listener listener_;
  std::mutex reporting_;  ///< guards the last report and calls of the listener
  std::atomic<double> fraction_{0};
  std::string message_;
  std::atomic<Clock::rep> told_{0};    ///< time of the last report
  std::atomic<std::size_t> stage_{0};  ///< hash of its description
  std::atomic<bool> cancelled_{false};
};

}  // namespace fieldfab
