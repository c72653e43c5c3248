/// Parallel loops over oneTBB, and a limit on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace fieldfab {

/// Limits the threads of all parallel loops to `threads` (0: the number of cores) during its lifetime. Created once, by
/// main() or a test.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// Calls body(i) for each i in [0, count), in parallel and in any order. Rethrows the first exception of a call; calls
/// that have not begun are then omitted. A loop that returns has made all its calls, also within a loop that has
/// failed.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace fieldfab
