/// Colours of parts, as people name them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fieldfab {

/// An opaque sRGB colour, 0 to 255 a channel.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
  /// Red, green and blue by their places, 0 to 2.
  constexpr std::uint8_t& operator[](std::size_t i) { return i == 0 ? red : i == 1 ? green : blue; }
  constexpr std::uint8_t operator[](std::size_t i) const { return i == 0 ? red : i == 1 ? green : blue; }
};

/// The colour of "#rgb" or "#rrggbb"; none for any other text.
std::optional<Colour> colour_of_hex(std::string_view text);

/// The colour of a CSS name (CSS Color 4, 148 names, upper and lower case alike), of "#rgb" or of "#rrggbb". Throws
/// bad_input for any other text, with the nearest name where one is near.
Colour colour_named(std::string_view text);

/// The CSS names, in alphabetic order.
std::vector<std::string_view> colour_names();

/// "#rrggbb", in lower case.
std::string text_of(Colour colour);

}  // namespace fieldfab
