/// Child processes: programs started without a shell, whose output is read here.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fieldfab {

/// Parameters of a child process.
struct ChildSettings {
  std::vector<std::string> words;  ///< the program's name, searched in PATH, then its arguments; must not be empty
  /// entries of the form NAME=VALUE; default: this process's environment
  std::optional<std::vector<std::string>> environment = {};
  std::uintmax_t memory = 0;  ///< limit of its address space in bytes (RLIMIT_AS); 0: no limit
  /// whether standard error is read together with standard output; standard input is then /dev/null
  bool errors_too = false;
};

/// A child process in its own process group, with its standard output connected to a pipe. The kernel kills the process
/// (SIGKILL) when the thread that created this object ends, even by SIGKILL. The destructor kills the whole process
/// group.
class Child {
 public:
  /// Starts the program. Throws Error(io) if it cannot be started; `advice` replaces the system's message if the
  /// program does not exist.
  explicit Child(const ChildSettings& settings, const std::string& advice = "");
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Appends available output to `text`. Waits at most 50 ms for it. Returns false at the end of the output, true
  /// otherwise, also if no bytes arrived.
  bool read(std::string& text) const;
  /// Blocks until the program ends, then kills the rest of its process group. Returns the status in the encoding of
  /// waitpid().
  int wait();

 private:
  pid_t process_ = 0;
  int output_ = -1;
};

}  // namespace fieldfab
