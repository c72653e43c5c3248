// Values of ShopBot's part files: numbers, variables, expressions, conditions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace fieldfab::cam::gcode::sbp {

std::string_view trimmed(std::string_view text);
std::string upper(std::string_view text);
inline bool letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
inline bool digit(char c) { return c >= '0' && c <= '9'; }
/// Removes '&' and the name behind it, and returns the name in upper case.
std::string variable_name(std::string_view& rest);

/// The program's variables, and expressions of them. Functions throw Refusal for invalid text.
class Values {
 public:
  /// Evaluates an expression: + - * / and parentheses, with finite results.
  [[nodiscard]] double value(std::string_view text) const;
  /// Evaluates a comparison; an expression is true unless it is 0.
  [[nodiscard]] bool condition(std::string_view text) const;
  void set(const std::string& name, double value);
  void forget(const std::string& name) { variables_.erase(name); }

 private:
  double sum(std::string_view& rest, int depth) const;
  double product(std::string_view& rest, int depth) const;
  double factor(std::string_view& rest, int depth) const;

  std::map<std::string, double> variables_;
};

}  // namespace fieldfab::cam::gcode::sbp
