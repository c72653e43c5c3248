/// Execution of a function in a forked copy of this process, for libraries that may abort or overwrite memory.
#pragma once

#include <functional>

#include "fieldfab/core/progress.h"

namespace fieldfab {

/// How a copy of this process ended.
enum class CopyEnd {
  completed,  ///< its work was done, or threw an exception
  crashed,    ///< it was ended, for example by a failed assertion
  /// There was no copy, because the system cannot fork; or it used no processor time for 5 s and was given up: it then
  /// waits for a lock of a thread that it lacks.
  unknown,
};

/// Runs `work` in a forked copy of this process. The copy ends afterwards, and its results are lost, except those in
/// shared memory. Its standard output and standard error are discarded. Destructors of what `work` refers to do not run
/// in the copy. Throws Error(cancelled) after cancellation of `progress`; the copy is then killed within 50 ms. Throws
/// Error(too_large) if the system killed the copy because there was no memory left. Precondition: `work` uses no other
/// threads, because the copy has only the calling one.
CopyEnd run_in_copy(const std::function<void()>& work, Progress& progress);

}  // namespace fieldfab
