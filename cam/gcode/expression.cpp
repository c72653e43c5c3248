#include "expression.h"

#include <array>
#include <charconv>
#include <cmath>

#include "fieldfab/core/angle.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr int deepest = 100;             // greatest depth of nested brackets
constexpr double equal_within = 0.0001;  // tolerance of EQ and NE, as in LinuxCNC

enum class Operator : std::uint8_t {
  none,
  power,
  times,
  divide,
  modulo,
  plus,
  minus,
  eq,
  ne,
  gt,
  ge,
  lt,
  le,
  both,
  either,
  one_of
};

int rank(Operator op) {
  switch (op) {
    case Operator::power: return 5;
    case Operator::times:
    case Operator::divide:
    case Operator::modulo: return 4;
    case Operator::plus:
    case Operator::minus: return 3;
    case Operator::both:
    case Operator::either:
    case Operator::one_of: return 1;
    case Operator::none: return 0;
    default: return 2;
  }
}

Operator read_operator(Cursor& cursor) {
  struct Word {
    std::string_view text;
    Operator op;
  };
  static constexpr std::array<Word, 15> words{{{"**", Operator::power},
                                               {"*", Operator::times},
                                               {"/", Operator::divide},
                                               {"+", Operator::plus},
                                               {"-", Operator::minus},
                                               {"mod", Operator::modulo},
                                               {"eq", Operator::eq},
                                               {"ne", Operator::ne},
                                               {"gt", Operator::gt},
                                               {"ge", Operator::ge},
                                               {"lt", Operator::lt},
                                               {"le", Operator::le},
                                               {"and", Operator::both},
                                               {"or", Operator::either},
                                               {"xor", Operator::one_of}}};
  for (const Word& word : words)
    if (cursor.take(word.text)) return word.op;
  refuse("'{}' found where an operator or ']' should be", shown(cursor.text.substr(cursor.at)));
}

double apply(Operator op, double a, double b) {
  switch (op) {
    case Operator::power:
      if (a < 0 && b != std::floor(b)) refuse("{} ** {}: a negative number to a power that is not whole", a, b);
      return std::pow(a, b);
    case Operator::times: return a * b;
    case Operator::divide:
      if (b == 0) refuse("division by zero");
      return a / b;
    case Operator::modulo: {
      if (b == 0) refuse("MOD of zero");
      const double rest = std::fmod(a, b);
      return rest < 0 ? rest + std::abs(b) : rest;
    }
    case Operator::plus: return a + b;
    case Operator::minus: return a - b;
    case Operator::eq: return std::abs(a - b) < equal_within ? 1 : 0;
    case Operator::ne: return std::abs(a - b) < equal_within ? 0 : 1;
    case Operator::gt: return a > b ? 1 : 0;
    case Operator::ge: return a >= b ? 1 : 0;
    case Operator::lt: return a < b ? 1 : 0;
    case Operator::le: return a <= b ? 1 : 0;
    case Operator::both: return a != 0 && b != 0 ? 1 : 0;
    case Operator::either: return a != 0 || b != 0 ? 1 : 0;
    case Operator::one_of: return (a != 0) != (b != 0) ? 1 : 0;
    case Operator::none: break;
  }
  return b;
}

double finite(double value) {
  if (!std::isfinite(value)) refuse("the result is no finite number");
  return value;
}

double read_bracket(Cursor& cursor, const Parameters& parameters, int depth);

/// Evaluates operators of rank `least` and above that follow the operand `left`. `next` receives
/// the operator that ends the expression.
double read_operations(Cursor& cursor, const Parameters& parameters, int depth, double left, int least,
                       Operator& next) {
  while (rank(next) >= least && next != Operator::none) {
    const Operator op = next;
    double right = read_value(cursor, parameters, depth + 1);
    next = cursor.take(']') ? Operator::none : read_operator(cursor);
    if (rank(next) > rank(op)) right = read_operations(cursor, parameters, depth, right, rank(op) + 1, next);
    left = finite(apply(op, left, right));
  }
  return left;
}

double read_bracket(Cursor& cursor, const Parameters& parameters, int depth) {
  const double first = read_value(cursor, parameters, depth + 1);
  if (cursor.done()) refuse("'[' without its ']'");
  Operator next = cursor.take(']') ? Operator::none : read_operator(cursor);
  return read_operations(cursor, parameters, depth, first, 1, next);
}

double read_argument(Cursor& cursor, const Parameters& parameters, int depth) {
  if (!cursor.take('[')) refuse("a function's argument must stand in brackets");
  return read_bracket(cursor, parameters, depth);
}

/// EXISTS[#<name>], or EXISTS[#5], which is true for all numbered parameters.
double read_exists(Cursor& cursor, const Parameters& parameters) {
  if (!cursor.take("[#")) refuse("EXISTS must be written as EXISTS[#<name>]");
  bool found = true;
  if (cursor.take('<'))
    found = parameters.find(read_name(cursor)).has_value();
  else
    while (!cursor.done() && cursor.peek() != ']') ++cursor.at;
  if (!cursor.take(']')) refuse("'[' without its ']'");
  return found ? 1 : 0;
}

double read_function(Cursor& cursor, const Parameters& parameters, int depth) {
  const auto argument = [&] { return read_argument(cursor, parameters, depth); };
  if (cursor.take("exists")) return read_exists(cursor, parameters);
  if (cursor.take("abs")) return std::abs(argument());
  if (cursor.take("acos")) {
    const double x = argument();
    if (std::abs(x) > 1) refuse("ACOS of {}, which is not between -1 and 1", x);
    return std::acos(x) * degrees_per_radian;
  }
  if (cursor.take("asin")) {
    const double x = argument();
    if (std::abs(x) > 1) refuse("ASIN of {}, which is not between -1 and 1", x);
    return std::asin(x) * degrees_per_radian;
  }
  if (cursor.take("atan")) {
    const double y = argument();
    if (!cursor.take('/')) refuse("ATAN must be written as ATAN[y]/[x]");
    const double x = argument();
    return std::atan2(y, x) * degrees_per_radian;
  }
  if (cursor.take("cos")) return std::cos(argument() / degrees_per_radian);
  if (cursor.take("exp")) return std::exp(argument());
  if (cursor.take("fix")) return std::floor(argument());
  if (cursor.take("fup")) return std::ceil(argument());
  if (cursor.take("ln")) {
    const double x = argument();
    if (x <= 0) refuse("LN of {}, which is not above 0", x);
    return std::log(x);
  }
  if (cursor.take("round")) return std::round(argument());
  if (cursor.take("sin")) return std::sin(argument() / degrees_per_radian);
  if (cursor.take("sqrt")) {
    const double x = argument();
    if (x < 0) refuse("SQRT of {}, which is below 0", x);
    return std::sqrt(x);
  }
  if (cursor.take("tan")) return std::tan(argument() / degrees_per_radian);
  refuse("'{}' found where a value should be", shown(cursor.text.substr(cursor.at)));
}

double read_number(Cursor& cursor) {
  const char* const begin = cursor.text.data() + cursor.at;
  const char* const end = cursor.text.data() + cursor.text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value, std::chars_format::fixed);
  if (error != std::errc()) refuse("'{}' found where a number should be", shown(cursor.text.substr(cursor.at)));
  cursor.at += static_cast<std::size_t>(stop - begin);
  return value;
}

}  // namespace

double read_value(Cursor& cursor, const Parameters& parameters, int depth) {
  const char c = cursor.peek();
  if ((c >= '0' && c <= '9') || c == '.') return read_number(cursor);
  if (depth > deepest) refuse("more than {} brackets within brackets", deepest);
  switch (c) {
    case '-': ++cursor.at; return -read_value(cursor, parameters, depth + 1);
    case '+': ++cursor.at; return read_value(cursor, parameters, depth + 1);
    case '[': ++cursor.at; return read_bracket(cursor, parameters, depth + 1);
    case '#': {
      ++cursor.at;
      if (cursor.take('<')) return parameters.get(read_name(cursor));
      return parameters.get(whole(read_value(cursor, parameters, depth + 1)));
    }
    case '\0': refuse("the line ends where a value should be");
    default: return finite(read_function(cursor, parameters, depth + 1));
  }
}

int whole(double value, int limit) {
  const double rounded = std::round(value);
  if (!(std::abs(value - rounded) <= 0.0001)) refuse("{} found where a whole number should be", value);
  if (std::abs(rounded) > limit) refuse("{} is too large", value);
  return static_cast<int>(rounded);
}

int read_whole(Cursor& cursor, const Parameters& parameters) { return whole(read_value(cursor, parameters)); }

std::string_view read_name(Cursor& cursor) {
  const std::size_t end = cursor.text.find('>', cursor.at);
  if (end == std::string_view::npos) refuse("'<' without its '>'");
  const std::string_view name = cursor.text.substr(cursor.at, end - cursor.at);
  cursor.at = end + 1;
  return name;
}

}  // namespace fieldfab::cam::gcode
