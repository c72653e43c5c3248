// Any bytes as a math string: an Error, or an expression whose printed form is read as the same
// expression.
#include <cstdlib>

#include "fieldfab/core/error.h"
#include "fieldfab/frep/text.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  try {
    const frep::Expression expression = frep::parse_math({reinterpret_cast<const char*>(data), size});
    if (!(frep::parse_math(frep::print_math(expression)) == expression)) std::abort();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input && error.kind() != ErrorKind::too_large) std::abort();
  }
  return 0;
}
