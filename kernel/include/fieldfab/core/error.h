/// The exception class of the library. It holds the kind, the place and the description of a failure.
#pragma once

#include <stdexcept>
#include <string>

namespace fieldfab {

/// Kind of a failure. The command maps each kind to an exit code.
enum class ErrorKind {
  bad_input,  ///< unusable file, expression or option (exit code 2)
  io,         ///< failure to read or write a file (exit code 2)
  too_large,  ///< request for more memory than is available (exit code 2)
  cancelled,  ///< cancellation by the caller's Progress (exit code 130)
  internal,   ///< violation of an internal invariant, which is a defect of Fieldfab (exit code 3)
};

/// Exception thrown at public boundaries. `what()` is "PLACE: MESSAGE" on one line. PLACE is a file name,
/// FILE:LINE:COLUMN or an option; it may be empty, and `what()` is then the message alone.
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
