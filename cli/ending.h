/// End of the command: by signals, lack of memory, uncaught exceptions.
#pragma once

#include "fieldfab/core/progress.h"

namespace fieldfab::cli {

enum ExitCode { done = 0, check_failed = 1, bad_input = 2, internal_error = 3, cancelled = 130 };

/// During its lifetime, SIGINT, SIGTERM and SIGHUP cancel the work. Work that does not stop by
/// itself is ended 0.3 s later from another thread, and its temporary files are removed. A pipe
/// without a reader and a file over its limit cause errors of write(), not signals. Exceptions that
/// nobody catches, such as a lack of memory in a library's thread, and abort() end the command with
/// a message and exit code 3.
class Ending {
 public:
  explicit Ending(Progress& progress);
  ~Ending();
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;

  /// States that the work has ended by itself, and that its result counts. Does not return if the
  /// work was ended from outside.
  void settle() noexcept;
};

}  // namespace fieldfab::cli
