// Any bytes as .csg text: an Error, or a tree whose printed form is read as the same tree.
#include <cstdlib>

#include "fieldfab/core/error.h"
#include "fieldfab/openscad/tree.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  try {
    const openscad::Tree tree = openscad::parse_csg({reinterpret_cast<const char*>(data), size}, "fuzz");
    const std::string text = openscad::print_csg(tree, 0);
    const openscad::Tree again = openscad::parse_csg(text, "again");
    // The parser returns the text's nodes in a group of their own.
    if (openscad::print_csg(again, again.top().children.at(0)) != text) std::abort();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input && error.kind() != ErrorKind::too_large) std::abort();
  }
  return 0;
}
