/// Names of enumerators in files.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <string_view>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"

namespace fieldfab::cam {

/// Returns the enumerator with a name. `names` are in the enumeration's order; `what` is the key of
/// the value. Throws Error(bad_input) at `place`, with the nearest name.
template <class Enumeration, std::size_t count>
Enumeration named(std::string_view name, const std::array<std::string_view, count>& names, std::string_view what,
                  const std::string& place) {
  for (std::size_t i = 0; i < count; ++i)
    if (names[i] == name) return static_cast<Enumeration>(i);
  throw Error(ErrorKind::bad_input, place,
              fmt::format("{} is '{:.40}'; it must be one of {}{}", what, name, fmt::join(names, ", "),
                          fieldfab::suggestion(name, names)));
}

}  // namespace fieldfab::cam
