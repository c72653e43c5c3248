/// Enumerations by the names that files have for their values.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"

namespace fieldfab::cam {

/// The value whose name it is: `names` are in the enumeration's order. Throws bad_input at `place`, with the nearest name; `what`
/// is the key that has the value.
template <class Enumeration, std::size_t count>
Enumeration named(std::string_view name, const std::array<std::string_view, count>& names, std::string_view what,
                  const std::string& place) {
  for (std::size_t i = 0; i < count; ++i)
    if (names[i] == name) return static_cast<Enumeration>(i);
  throw Error(ErrorKind::bad_input, place,
              fmt::format("{} is '{:.40}'; it must be one of {}{}", what, name, fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fieldfab::cam
