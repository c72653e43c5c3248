#include "work.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "cancel_button.h"

namespace fieldfab::meshlab {

void work_beside(const std::function<void(Progress&)>& work, Bar* bar) {
  std::mutex lock;
  std::condition_variable done_or_news;
  int percent = 0;
  std::string doing = "Fieldfab";
  bool done = false;
  std::exception_ptr failure;

  Progress progress([&](double fraction, const std::string& message) {
    const std::lock_guard guard(lock);
    percent = static_cast<int>(std::clamp(100 * fraction, 0.0, 99.0));
    if (!message.empty()) doing = message;
  });
  std::thread worker([&] {
    try {
      work(progress);
      progress.check();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard guard(lock);
    done = true;
    done_or_news.notify_one();
  });

  CancelButton button;
  std::unique_lock guard(lock);
  while (!done_or_news.wait_for(guard, std::chrono::milliseconds(30), [&] { return done; })) {
    const int at = percent;
    const std::string what = doing + " ...";
    guard.unlock();
    const bool go_on = bar == nullptr || bar(at, what.c_str());
    if (!go_on || button.pressed()) progress.cancel();
    guard.lock();
  }
  guard.unlock();
  worker.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fieldfab::meshlab
