// Errors of the readers of programs, without a place: only the outermost loop knows it.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// Carries a message to the loop over blocks, which adds file and line and throws Error(bad_input).
struct Refusal {
  std::string message;
};

template <class... Arguments>
[[noreturn]] void refuse(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw Refusal{fmt::format(text, std::forward<Arguments>(arguments)...)};
}

/// A text as shown in messages: short, and without control characters.
inline std::string shown(std::string_view text) {
  std::string out(text.substr(0, 40));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return out;
}

/// Notes for the caller: each message once, with the first line that caused it, so that their
/// number does not grow with the program.
class Notes {
 public:
  void add(int line, std::string message) {
    if (notes_.size() >= most || !given_.insert(message).second) return;
    if (notes_.size() + 1 == most) message = "more notes than these are left out";
    notes_.push_back({line, std::move(message)});
  }
  std::vector<ReadingNote> take() { return std::move(notes_); }

 private:
  static constexpr std::size_t most = 1000;
  std::set<std::string> given_;
  std::vector<ReadingNote> notes_;
};

}  // namespace fieldfab::cam::gcode
