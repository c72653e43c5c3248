/// Other programs, run without a shell.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fieldfab {

/// How a program is run.
struct ChildSettings {
  std::vector<std::string> words;                            ///< the program, looked for in PATH, and its arguments
  std::optional<std::vector<std::string>> environment = {};  ///< NAME=VALUE; ours where not given
  std::uintmax_t memory = 0;                                 ///< bytes it may have; 0 means no limit
  bool errors_too = false;  ///< its standard error is read as well, and its standard input is empty
};

/// A program that runs in a process group of its own, whose output is read here. It ends with this object, and with the
/// thread that made this object, even if that is killed.
class Child {
 public:
  /// Throws io where it cannot be started; `advice` is added where there is no such program.
  explicit Child(const ChildSettings& settings, const std::string& advice = "");
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Adds what it wrote to `text`, waiting a little for more; false at its end.
  bool read(std::string& text) const;
  /// Waits for its end, and ends what it left behind; the status, as waitpid() tells it.
  int wait();

 private:
  pid_t process_ = 0;
  int output_ = -1;
};

}  // namespace fieldfab
