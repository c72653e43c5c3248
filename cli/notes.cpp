#include <algorithm>
#include <cctype>

#include "fieldfab/core/lower_case.h"
#include "fieldfab/core/text.h"
#include "streams.h"
#include "verbs.h"

namespace fieldfab::cli {

std::string extension_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".gz" ? lower_extension(path.stem()) + extension : extension;
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) tell({"fieldfab: note: ", printable(note), "\n"});
}

}  // namespace fieldfab::cli
