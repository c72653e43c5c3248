#include "sbp_values.h"

#include <charconv>
#include <cmath>

#include "refusal.h"

namespace fieldfab::cam::gcode::sbp {
namespace {

constexpr std::size_t most_variables = 100'000;
constexpr int deepest_brackets = 100;

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && static_cast<unsigned char>(text.front()) <= 32) text.remove_prefix(1);
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= 32) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  return out;
}

std::string variable_name(std::string_view& rest) {
  rest.remove_prefix(1);
  std::size_t length = 0;
  while (length < rest.size() && (letter(rest[length]) || digit(rest[length]))) ++length;
  if (length == 0) refuse("& without the name of a variable");
  std::string name = upper(rest.substr(0, length));
  rest.remove_prefix(length);
  return name;
}

double Values::value(std::string_view text) const {
  std::string_view rest = trimmed(text);
  const double result = sum(rest, 0);
  if (!trimmed(rest).empty()) refuse("'{}' found behind a value", shown(trimmed(rest)));
  if (!std::isfinite(result)) refuse("the result is no finite number");
  return result;
}

double Values::sum(std::string_view& rest, int depth) const {
  double result = product(rest, depth);
  while (true) {
    rest = trimmed(rest);
    if (rest.empty() || (rest.front() != '+' && rest.front() != '-')) return result;
    const bool plus = rest.front() == '+';
    rest.remove_prefix(1);
    const double next = product(rest, depth);
    result += plus ? next : -next;
  }
}

double Values::product(std::string_view& rest, int depth) const {
  double result = factor(rest, depth);
  while (true) {
    rest = trimmed(rest);
    if (rest.empty() || (rest.front() != '*' && rest.front() != '/')) return result;
    const bool times = rest.front() == '*';
    rest.remove_prefix(1);
    const double next = factor(rest, depth);
    if (!times && next == 0) refuse("division by zero");
    result = times ? result * next : result / next;
  }
}

double Values::factor(std::string_view& rest, int depth) const {
  rest = trimmed(rest);
  if (depth > deepest_brackets) refuse("more than {} brackets within brackets", deepest_brackets);
  if (rest.empty()) refuse("a value is missing");
  const char c = rest.front();
  if (c == '-' || c == '+') {
    rest.remove_prefix(1);
    const double inner = factor(rest, depth + 1);
    return c == '-' ? -inner : inner;
  }
  if (c == '(') {
    rest.remove_prefix(1);
    const double inner = sum(rest, depth + 1);
    rest = trimmed(rest);
    if (rest.empty() || rest.front() != ')') refuse("'(' without its ')'");
    rest.remove_prefix(1);
    return inner;
  }
  if (c == '&') {
    const std::string name = variable_name(rest);
    const auto found = variables_.find(name);
    if (found == variables_.end()) refuse("the variable &{} has no value", shown(name));
    return found->second;
  }
  if (c == '%') refuse("the control's own variables (%) are not known here");
  double number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number, std::chars_format::fixed);
  if (error != std::errc()) refuse("'{}' found where a value should be", shown(rest));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return number;
}

bool Values::condition(std::string_view text) const {
  const std::size_t at = text.find_first_of("<>=");
  if (at == std::string_view::npos) return value(text) != 0;
  std::size_t length = 1;
  while (at + length < text.size() &&
         (text[at + length] == '=' || text[at + length] == '>' || text[at + length] == '<'))
    ++length;
  const std::string_view sign = text.substr(at, length);
  const double a = value(text.substr(0, at)), b = value(text.substr(at + length));
  if (sign == "=" || sign == "==") return a == b;
  if (sign == "<>") return a != b;
  if (sign == "<") return a < b;
  if (sign == ">") return a > b;
  if (sign == "<=") return a <= b;
  if (sign == ">=") return a >= b;
  refuse("'{}' compares nothing", shown(sign));
}

void Values::set(const std::string& name, double value) {
  if (variables_.size() >= most_variables && !variables_.contains(name))
    refuse("more than {} variables", most_variables);
  variables_[name] = value;
}

}  // namespace fieldfab::cam::gcode::sbp
