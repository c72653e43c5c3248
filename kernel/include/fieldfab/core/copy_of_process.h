/// Work tried in a copy of this process first, where it may end the process that it runs in.
#pragma once

#include <functional>

#include "fieldfab/core/progress.h"

namespace fieldfab {

/// Runs `work` in a forked copy of this process, which is gone afterwards with all that it made. Returns whether the copy came
/// to the end of the work, be it by an exception; false where a library ended it, at an assertion for instance. True, too,
/// where the system refuses a copy. Throws cancelled, and the copy is killed then. The work must not use other threads: the copy
/// has none.
bool ends_by_itself(const std::function<void()>& work, Progress& progress);

}  // namespace fieldfab
