/// Parallel loops over oneTBB, and the number of threads they may use.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace fieldfab {

/// While it lives, parallel loops started anywhere use at most `threads` threads (0: all cores). Made once by main or a test.
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

/// Calls body(i) for each i in [0, count), in any order and in parallel. The first exception thrown is thrown here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace fieldfab
