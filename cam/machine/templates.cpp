#include "templates.h"

#include <algorithm>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {

std::string Templates::fill(const std::string& key) {
  const auto found = machine_.text.find(key);
  if (found == machine_.text.end()) return {};
  const std::string& pattern = found->second;
  std::string out;
  bool any_bracket = false, any_written = false;
  for (std::size_t i = 0; i < pattern.size();) {
    if (pattern[i] == '[') {
      const std::size_t end = pattern.find(']', i);
      if (end == std::string::npos) refuse(key, "has '[' without ']'");
      any_bracket = true;
      const std::string piece = bracket(pattern.substr(i + 1, end - i - 1), key);
      any_written |= !piece.empty();
      out += piece;
      i = end + 1;
    } else if (pattern[i] == '{') {
      const std::string name = pattern.substr(i + 1, pattern.find('}', i) - i - 1);
      out += written_[name] = value(pattern, i, key);
      any_written = true;
    } else {
      out += pattern[i++];
    }
  }
  // all text was in brackets and unchanged: no move
  return any_bracket && !any_written ? std::string() : out;
}

void Templates::refuse(const std::string& key, const std::string& what) const {
  throw Error(ErrorKind::bad_input, machine_.file, fmt::format("the template {} {}", key, what));
}

std::string Templates::bracket(const std::string& pattern, const std::string& key) {
  std::string out;
  bool changed = false;
  for (std::size_t i = 0; i < pattern.size();) {
    if (pattern[i] != '{') {
      out += pattern[i++];
      continue;
    }
    const std::string name = pattern.substr(i + 1, pattern.find('}', i) - i - 1);
    const std::string text = value(pattern, i, key);
    std::string& before = written_[name];
    changed |= before != text;
    before = text;
    out += text;
  }
  return changed ? out : std::string();
}

/// The value of the {...} at `i`, which is advanced behind it.
std::string Templates::value(const std::string& pattern, std::size_t& i, const std::string& key) {
  const std::size_t end = pattern.find('}', i);
  if (end == std::string::npos) refuse(key, "has '{' without '}'");
  std::string name = pattern.substr(i + 1, end - i - 1), bytes;
  i = end + 1;
  if (const std::size_t colon = name.find(':'); colon != std::string::npos)
    bytes = name.substr(colon + 1), name.resize(colon);
  double factor = 1;
  bool scaled = false;
  if (const std::size_t star = name.find('*'); star != std::string::npos) {
    factor = std::stod(name.substr(star + 1));
    name.resize(star);
    scaled = true;
  }
  const auto text = texts_.find(name);
  if (text == texts_.end()) refuse(key, fmt::format("uses {{{}}}, which has no value", name));
  if (!scaled && bytes.empty()) return text->second;
  const auto number = numbers_.find(name);
  if (number == numbers_.end()) refuse(key, fmt::format("needs a number for {}", name));
  if (bytes.empty()) return number_text(number->second * factor, machine_.decimals);
  const auto whole = static_cast<unsigned>(std::clamp(std::llround(number->second * factor), 0LL, 65535LL));
  if (bytes == "i") return fmt::format("{}", std::llround(number->second * factor));
  if (bytes == "d4") return fmt::format("{:04d}", whole);
  if (bytes == "u8") return {static_cast<char>(whole & 255U)};
  if (bytes == "u16") return {static_cast<char>(whole >> 8U), static_cast<char>(whole & 255U)};
  refuse(key, fmt::format("knows no form '{}'; there are i, d4, u8 and u16", bytes));
}

}  // namespace fieldfab::cam
