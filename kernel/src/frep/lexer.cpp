#include "lexer.h"

#include <algorithm>

namespace fieldfab::frep {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 128; }

}  // namespace

std::optional<Token> Lexer::next() noexcept {
  for (; at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos; ++at_)
    if (text_[at_] == '\n') ++line_, line_start_ = at_ + 1;
  if (at_ >= text_.size()) return std::nullopt;
  const std::size_t first = at_;
  const char c = text_[first];
  const auto byte = [&](std::size_t i) { return i < text_.size() ? text_[i] : '\0'; };
  const auto token = [&](TokenKind kind, std::size_t end) {
    at_ = end;
    return Token{kind, first, end - first, line_, first - line_start_ + 1};
  };
  const auto end_of = [&](auto belongs) {
    std::size_t end = first + 1;
    while (end < text_.size() && belongs(text_[end])) ++end;
    return end;
  };
  if (c == '#' || (c == '/' && byte(first + 1) == '/'))
    return token(TokenKind::comment, end_of([](char d) { return d != '\n'; }));
  if (c == '"') return token(TokenKind::string, string_end());
  if (is_digit(c) || (c == '.' && is_digit(byte(first + 1)))) return token(TokenKind::number, number_end());
  if (is_letter(c)) return token(TokenKind::name, end_of([](char d) { return is_letter(d) || is_digit(d); }));
  if (std::string_view("+-*/^(),=|&!;").find(c) != std::string_view::npos) return token(TokenKind::sign, first + 1);
  return token(TokenKind::unknown, is_ascii(c) ? first + 1 : end_of([](char d) { return !is_ascii(d); }));
}

/// Matches the extent that std::from_chars reads.
std::size_t Lexer::number_end() const noexcept {
  const auto digits_from = [&](std::size_t i) {
    while (i < text_.size() && is_digit(text_[i])) ++i;
    return i;
  };
  std::size_t end = digits_from(at_);
  if (end < text_.size() && text_[end] == '.') end = digits_from(end + 1);
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
    if (const std::size_t after = digits_from(exponent); after > exponent) end = after;
  }
  return end;
}

/// Returns the end of the closing quotes, or of the line if they are missing. Quotes after a
/// backslash do not close.
std::size_t Lexer::string_end() const noexcept {
  std::size_t end = at_ + 1;
  while (end < text_.size() && text_[end] != '"' && text_[end] != '\n')
    end += text_[end] == '\\' && end + 1 < text_.size() && text_[end + 1] != '\n' ? 2 : 1;
  return end < text_.size() && text_[end] == '"' ? end + 1 : end;
}

bool is_closed(std::string_view string) noexcept {
  if (string.size() < 2 || string.back() != '"') return false;
  std::size_t backslashes = 0;
  while (string[string.size() - 2 - backslashes] == '\\') ++backslashes;
  return backslashes % 2 == 0;
}

}  // namespace fieldfab::frep
