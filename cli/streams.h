/// Output to the standard streams that neither throws nor ends the process if a stream is closed,
/// full or broken.
#pragma once

#include <initializer_list>
#include <string_view>

namespace fieldfab::cli {

/// Replaces closed standard streams by /dev/null. Otherwise the next file opened would get their
/// numbers, and the printed text.
void open_closed_streams() noexcept;

/// Writes to standard error; drops text that cannot be written. Allocates no memory.
void tell(std::initializer_list<std::string_view> parts) noexcept;

/// Writes to standard output. Throws Error(io) unless all of it is written.
void answer(std::string_view text);

}  // namespace fieldfab::cli
