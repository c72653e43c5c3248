/// Text from files, as it may be shown.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fieldfab {

/// The same as one line of valid UTF-8: bytes that are none become U+FFFD, control characters blanks. For messages: files can say
/// anything.
std::string printable(std::string_view bytes);

/// "; did you mean 'NAME'?" with the known name that differs from a mistyped one by the fewest letters, two at most; empty
/// where none is so near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace fieldfab
