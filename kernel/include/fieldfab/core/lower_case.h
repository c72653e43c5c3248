/// Lower case of ASCII text, for names that are compared without regard to case. Other bytes, such as those of UTF-8,
/// stay as they are.
#pragma once

#include <filesystem>
#include <string>

namespace fieldfab {

inline std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns the extension with its dot in lower case: ".stl" for "PART.STL", "" for a name without a dot.
inline std::string lower_extension(const std::filesystem::path& path) { return lower_case(path.extension().string()); }

}  // namespace fieldfab
