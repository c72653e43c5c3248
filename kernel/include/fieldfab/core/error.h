/// The one exception of the library: what went wrong, of which kind, and where.
#pragma once

#include <stdexcept>
#include <string>

namespace fieldfab {

/// What sort of failure it is; the command line turns each into an exit code.
enum class ErrorKind {
  bad_input,  ///< a file, an expression or an option that cannot be used (exit 2)
  io,         ///< a file that cannot be read or written (exit 2)
  too_large,  ///< a request that would need more memory than there is (exit 2)
  cancelled,  ///< the caller's Progress said stop (exit 130)
  internal,   ///< a promise of ours was broken (exit 3)
};

/// Thrown at public boundaries. `what()` is "PLACE: MESSAGE" in one line, PLACE being a file, a file:line:column or an option.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string place, const std::string& message)
      : std::runtime_error(line(place, message)), kind_(kind), place_(std::move(place)) {}

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
  [[nodiscard]] const std::string& place() const noexcept { return place_; }

 private:
  static std::string line(const std::string& place, const std::string& message) {
    std::string text = place;
    if (!text.empty()) text.append(": ");
    return text.append(message);
  }

  ErrorKind kind_;
  std::string place_;
};

}  // namespace fieldfab
