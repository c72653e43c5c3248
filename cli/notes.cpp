#include <fmt/format.h>

#include "fieldfab/core/text.h"
#include "verbs.h"

namespace fieldfab::cli {

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) fmt::print(stderr, "fieldfab: note: {}\n", printable(note));
}

}  // namespace fieldfab::cli
