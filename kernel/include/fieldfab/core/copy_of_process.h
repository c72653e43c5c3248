/// Trial execution of a function in a forked copy of this process, for libraries that may abort.
#pragma once

#include <functional>

#include "fieldfab/core/progress.h"

namespace fieldfab {

/// Runs `work` in a forked copy of this process. The copy ends afterwards, and its results are lost. Its standard
/// output and standard error are discarded. Returns true if the copy completed the work; an exception counts as
/// completion. Returns false if the copy was ended, for example by a failed assertion. Returns true, too, if the system
/// cannot fork, or if the copy uses no processor time for 5 s: it then waits for a lock of a thread that it lacks.
/// Throws Error(cancelled) after cancellation of `progress`; the copy is then killed within 50 ms. Precondition: `work`
/// uses no other threads, because the copy has only the calling one.
bool ends_by_itself(const std::function<void()>& work, Progress& progress);

}  // namespace fieldfab
