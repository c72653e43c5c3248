/// Text from files, as it may be shown.
#pragma once

#include <string>
#include <string_view>

namespace fieldfab {

/// The same as one line of valid UTF-8: bytes that are none become U+FFFD, control characters blanks. For messages: files can say
/// anything.
std::string printable(std::string_view bytes);

}  // namespace fieldfab
