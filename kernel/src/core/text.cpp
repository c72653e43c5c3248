#include "fieldfab/core/text.h"

#include <algorithm>

namespace fieldfab {
namespace {

/// The bytes of the character that begins there; 0 where none does. No overlong forms, no surrogates, nothing above U+10FFFF.
std::size_t length_of_character(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U; };
  const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF)
    return follows(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && follows(2) ? 3 : 0;
  if (first >= 0xF0 && first <= 0xF4)
    return follows(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && follows(2) && follows(3) ? 4 : 0;
  return 0;
}

}  // namespace

std::string printable(std::string_view bytes) {
  std::string line;
  while (!bytes.empty()) {
    const std::size_t length = length_of_character(bytes);
    const bool control = length == 1 && (static_cast<unsigned char>(bytes[0]) < 32 || bytes[0] == 127);
    line += length == 0 ? "\uFFFD" : control ? " " : bytes.substr(0, length);
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

}  // namespace fieldfab
