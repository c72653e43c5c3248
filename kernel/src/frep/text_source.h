/// Common base of the parsers: positions in a text, error messages, numbers.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Far more operations than any design has; a larger file is refused before it fills the memory.
inline constexpr std::size_t most_operations = 16'000'000;

/// An error at a byte of a text.
struct TextError : Error {
  TextError(ErrorKind kind, std::string place, const std::string& text, std::size_t byte)
      : Error(kind, std::move(place), text), at(byte), message(text) {}
  std::size_t at;
  std::string message;  ///< without the place
};

/// A text with its name for messages.
class TextSource {
 public:
  TextSource(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  [[nodiscard]] std::string_view text() const { return text_; }

  /// Position of byte `at` as NAME:LINE:COLUMN.
  [[nodiscard]] std::string place(std::size_t at) const {
    at = std::min(at, text_.size());
    const std::string_view before = text_.substr(0, at);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t start = before.rfind('\n');
    const std::size_t column = start == std::string_view::npos ? at + 1 : at - start;
    return fmt::format("{}:{}:{}", name_, line, column);
  }

  /// Throws TextError at byte `at`.
  [[noreturn]] void fail(std::size_t at, const std::string& message, ErrorKind kind = ErrorKind::bad_input) const {
    throw TextError(kind, place(at), printable(message), at);
  }

  /// The byte at `at`, as shown in messages.
  [[nodiscard]] std::string shown(std::size_t at) const {
    if (at >= text_.size()) return "the end of the text";
    const char c = text_[at];
    if (c >= 33 && c < 127) return fmt::format("'{}'", c);
    return fmt::format("byte 0x{:02x}", static_cast<unsigned char>(c));
  }

  /// Reads a decimal number at `at` and moves past it. Fails if there is none, or if it exceeds
  /// single precision.
  double number(std::size_t& at) const {
    std::size_t start = at;
    if (start < text_.size() && text_[start] == '+') ++start;
    double value = 0;
    const char* first = text_.data() + start;
    const auto result = std::from_chars(first, text_.data() + text_.size(), value);
    if (result.ec == std::errc::result_out_of_range && std::abs(value) > 1)
      fail(at, fmt::format("{} is too large for a number in single precision", std::string_view(first, result.ptr)));
    if (result.ec == std::errc::invalid_argument) fail(at, fmt::format("expected a number, found {}", shown(at)));
    if (result.ec == std::errc::result_out_of_range) value = out_of_range(std::string_view(first, result.ptr), at);
    if (!std::isfinite(value)) fail(at, fmt::format("{} is not a finite number", std::string_view(first, result.ptr)));
    if (!std::isfinite(static_cast<float>(value)))
      fail(at, fmt::format("{} is too large for a number in single precision", std::string_view(first, result.ptr)));
    at = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
  }

 private:
  /// from_chars leaves the value unchanged on overflow and underflow; the sign of the exponent
  /// distinguishes them.
  double out_of_range(std::string_view digits, std::size_t at) const {
    const std::size_t exponent = digits.find_first_of("eE");
    if (exponent != std::string_view::npos && exponent + 1 < digits.size() && digits[exponent + 1] == '-') return 0;
    const std::string_view mantissa = digits.substr(0, exponent);
    if (exponent == std::string_view::npos && mantissa.starts_with("0.")) return 0;
    fail(at, fmt::format("{:.40} is too large for a number in single precision", digits));
  }

  std::string_view text_;
  std::string_view name_;
};

/// Throws bad_input if the expression opens a file: only .frep text can name files.
inline void require_no_opened(const Expression& expression) {
  if (has_opened(expression))
    throw Error(ErrorKind::bad_input, "", "a model that opens other files can be written as .frep text only");
}

/// Shortest text that reads back as the same number.
inline std::string number_text(double value) { return fmt::format("{}", value); }

}  // namespace fieldfab::frep
