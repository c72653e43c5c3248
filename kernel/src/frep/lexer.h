/// Division of .frep text into tokens, for the parser and for editors.
#pragma once

#include <optional>

#include "fieldfab/frep/language.h"

namespace fieldfab::frep {

class Lexer {
 public:
  /// Reads from byte `at`, the start of a line. Lines are counted from there.
  explicit Lexer(std::string_view text, std::size_t at = 0) : text_(text), at_(at), line_start_(at) {}

  /// Returns the next token, or nullopt at the end of the text.
  std::optional<Token> next() noexcept;

 private:
  [[nodiscard]] std::size_t number_end() const noexcept;
  [[nodiscard]] std::size_t string_end() const noexcept;

  std::string_view text_;
  std::size_t at_;
  std::size_t line_start_;
  std::size_t line_ = 1;
};

/// Whether a string token has its closing quotes.
bool is_closed(std::string_view string) noexcept;

}  // namespace fieldfab::frep
