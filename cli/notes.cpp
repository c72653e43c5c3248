#include <algorithm>
#include <cctype>

#include "fieldfab/core/text.h"
#include "streams.h"
#include "verbs.h"

namespace fieldfab::cli {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (extension == ".gz") extension = path.stem().extension().string() + extension;
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) tell({"fieldfab: note: ", printable(note), "\n"});
}

}  // namespace fieldfab::cli
