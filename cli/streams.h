/// The standard streams, written to in ways that neither throw nor end the process where one is closed, full or dead.
#pragma once

#include <initializer_list>
#include <string_view>

namespace fieldfab::cli {

/// Puts /dev/null in the place of closed standard streams: the next file opened would take their numbers, and get what
/// is printed.
void open_closed_streams() noexcept;

/// Writes to standard error; drops what cannot be written. Allocates no memory.
void tell(std::initializer_list<std::string_view> parts) noexcept;

/// Writes to standard output. Throws Error(io) where it takes less than all.
void answer(std::string_view text);

}  // namespace fieldfab::cli
