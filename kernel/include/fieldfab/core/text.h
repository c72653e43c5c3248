/// Text for messages: sanitized input, and suggestions for misspelled names.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fieldfab {

/// Returns `bytes` as one line of valid UTF-8 for messages. Invalid bytes become U+FFFD, control characters become
/// spaces.
std::string printable(std::string_view bytes);

/// Returns "; did you mean 'NAME'?" with the known name of least edit distance from `word`, if that distance is at most
/// 2; otherwise an empty string.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace fieldfab
