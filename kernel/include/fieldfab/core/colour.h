/// Colours of parts: sRGB values, hexadecimal notation and CSS names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fieldfab {

/// An opaque sRGB colour. Each channel is a whole number from 0 to 255.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
  /// Channel `i`: 0 is red, 1 is green, any other index is blue.
  constexpr std::uint8_t& operator[](std::size_t i) { return i == 0 ? red : i == 1 ? green : blue; }
  constexpr std::uint8_t operator[](std::size_t i) const { return i == 0 ? red : i == 1 ? green : blue; }
};

/// Parses "#rgb" or "#rrggbb", with digits in upper or lower case. Returns std::nullopt for any other text.
std::optional<Colour> colour_of_hex(std::string_view text);

/// Parses a CSS colour name (CSS Color Module Level 4, 148 names, case-insensitive), "#rgb" or "#rrggbb". Throws
/// Error(bad_input) for any other text; the message suggests the most similar name, if there is one.
Colour colour_named(std::string_view text);

/// Returns the CSS names in lower case and alphabetic order. They refer to static storage.
std::vector<std::string_view> colour_names();

/// Returns "#rrggbb" in lower case.
std::string text_of(Colour colour);

}  // namespace fieldfab
