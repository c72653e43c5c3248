// Any bytes as .frep text: an Error, or an expression whose printed form is read as the same
// expression; also the functions for editors.
#include <cstdlib>
#include <string>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/language.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace fieldfab;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string thrown;
  try {
    const frep::Expression expression = frep::parse_infix(text);
    if (!(frep::parse_infix(frep::print_infix(expression)) == expression)) std::abort();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input && error.kind() != ErrorKind::too_large) std::abort();
    thrown = printable(error.what());
  }
  const auto mistakes = frep::diagnostics(text);
  if (mistakes.empty() != thrown.empty() || (!mistakes.empty() && !thrown.ends_with(mistakes.front().message)))
    std::abort();
  std::size_t end = 0;
  for (const frep::Token& token : frep::tokens(text)) {
    if (token.length == 0 ||
        text.substr(end, token.offset - end).find_first_not_of(" \t\r\n") != std::string_view::npos)
      std::abort();
    end = token.offset + token.length;
  }
  if (text.substr(end).find_first_not_of(" \t\r\n") != std::string_view::npos) std::abort();
  for (const frep::TextParameter& parameter : frep::parameters(text))
    if (parameter.value_offset + parameter.value_length > size) std::abort();
  for (const std::size_t offset : {size / 3, size}) {
    if (frep::completions(text, offset).offset > size) std::abort();
    frep::word_at(text, offset);
  }
  return 0;
}
