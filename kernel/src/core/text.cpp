#include "fieldfab/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace fieldfab {
namespace {

/// Returns the length in bytes of the UTF-8 character at the start, or 0 if there is none. Overlong
/// forms, surrogates and characters above U+10FFFF are invalid.
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

/// Edit distance (Levenshtein) of two names.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, above + 1, diagonal + (a[i] != b[j])});
      diagonal = above;
    }
  }
  return row.back();
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

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  std::size_t least = 3;
  if (word.size() < 60)
    for (const std::string_view name : known)
      if (const std::size_t d = distance(word, name); d < least && d < name.size()) least = d, best = name;
  return best.empty() ? "" : fmt::format("; did you mean '{}'?", best);
}

}  // namespace fieldfab
