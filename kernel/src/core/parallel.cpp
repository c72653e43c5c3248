#include "fieldfab/core/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

namespace fieldfab {

struct ThreadLimit::Control {
  explicit Control(int threads)
      : limit(tbb::global_control::max_allowed_parallelism,
              static_cast<std::size_t>(threads > 0 ? threads : tbb::info::default_concurrency())) {}
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}
ThreadLimit::~ThreadLimit() = default;

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  // Isolated: an exception in a loop around this one would otherwise end this one early, without an exception here.
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(
      std::size_t{0}, count, [&](std::size_t i) { body(i); }, own);
}

}  // namespace fieldfab
