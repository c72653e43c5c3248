/// How the command ends: by signals, without memory, by what nobody catches.
#pragma once

#include "fieldfab/core/progress.h"

namespace fieldfab::cli {

enum ExitCode { done = 0, check_failed = 1, bad_input = 2, internal_error = 3, cancelled = 130 };

/// While it lives, SIGINT, SIGTERM and SIGHUP cancel the work. Work that does not stop by itself is ended from outside
/// 0.3 s later, its temporary files removed. A pipe without a reader and a file over its limit are errors of write(),
/// not signals. What nobody catches, such as a lack of memory in a library's thread, and abort() end the command with a
/// line and exit code 3.
class Ending {
 public:
  explicit Ending(Progress& progress);
  ~Ending();
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;

  /// The work has ended by itself, and its result counts. Does not return where it was ended from outside.
  void settle() noexcept;
};

}  // namespace fieldfab::cli
