// Infix .frep text: docs/frep-language.md is its manual. Precedence is resolved with stacks, so nesting costs memory only.
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "fieldfab/core/text.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/frep/text.h"
#include "text_source.h"

namespace fieldfab::frep {
namespace {

enum class TokenKind : std::uint8_t { number, name, words, sign, end_of_statement, end };

struct Token {
  TokenKind kind;
  std::size_t at;
  std::string_view text;
  double number = 0;
  [[nodiscard]] bool is(char sign) const { return kind == TokenKind::sign && text[0] == sign; }
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::vector<Token> tokens_of(const TextSource& source) {
  const std::string_view text = source.text();
  std::vector<Token> tokens;
  int open = 0;  // parentheses: a statement goes on over line ends within them
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ' ' || c == '\t' || c == '\r') {
      ++at;
    } else if (c == '#' || (c == '/' && at + 1 < text.size() && text[at + 1] == '/')) {
      at = std::min(text.find('\n', at), text.size());
    } else if (c == '\n' || c == ';') {
      if (c == ';' || open == 0) tokens.push_back({TokenKind::end_of_statement, at, text.substr(at, 1)});
      ++at;
    } else if (is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) {
      std::size_t after = at;
      const double value = source.number(after);
      if (after < text.size() && is_letter(text[after]))
        source.fail(after, fmt::format("unexpected {} after a number", source.shown(after)));
      tokens.push_back({TokenKind::number, at, text.substr(at, after - at), value});
      at = after;
    } else if (is_letter(c)) {
      std::size_t after = at;
      while (after < text.size() && (is_letter(text[after]) || is_digit(text[after]))) ++after;
      tokens.push_back({TokenKind::name, at, text.substr(at, after - at)});
      at = after;
    } else if (c == '"') {
      const std::size_t after = std::min(text.find('"', at + 1), text.find('\n', at + 1));
      if (after >= text.size() || text[after] != '"') source.fail(at, "the quotes opened here are not closed on this line");
      tokens.push_back({TokenKind::words, at, text.substr(at + 1, after - at - 1)});
      at = after + 1;
    } else if (std::string_view("+-*/^(),=|&!").find(c) != std::string_view::npos) {
      open += c == '(' ? 1 : c == ')' ? -1 : 0;
      tokens.push_back({TokenKind::sign, at, text.substr(at, 1)});
      ++at;
    } else {
      source.fail(at, fmt::format("unexpected {}", source.shown(at)));
    }
  }
  tokens.push_back({TokenKind::end, text.size(), {}});
  return tokens;
}

using Names = std::unordered_map<std::string_view, Expression>;

class InfixParser {
 public:
  InfixParser(std::string_view text, std::string_view name) : source_(text, name), tokens_(tokens_of(source_)) {}

  Expression parse() {
    std::optional<Expression> result;
    for (std::size_t at = 0; tokens_[at].kind != TokenKind::end;) {
      if (tokens_[at].kind == TokenKind::end_of_statement) {
        ++at;
        continue;
      }
      if (!define_function(at)) result = statement(at);
      if (tokens_[at].kind != TokenKind::end && tokens_[at].kind != TokenKind::end_of_statement)
        unexpected(at, "the end of the statement");
    }
    if (!result) source_.fail(source_.text().size(), "the text has no result: its last statement is the solid");
    return *result;
  }

 private:
  struct UserFunction {
    std::vector<std::string_view> parameters;
    std::size_t first;  // token where the body begins
    std::size_t order;  // functions may call those defined before them only
  };

  [[noreturn]] void unexpected(std::size_t at, const char* expected) const {
    const Token& token = tokens_[at];
    const std::string found = token.kind == TokenKind::end                ? "the end of the text"
                              : token.kind == TokenKind::end_of_statement ? "the end of the line"
                                                                          : fmt::format("'{:.40}'", token.text);
    source_.fail(token.at, fmt::format("expected {}, found {}", expected, found));
  }

  /// `name(a, b) = ...`; moves past it.
  bool define_function(std::size_t& at) {
    if (tokens_[at].kind != TokenKind::name || !tokens_[at + 1].is('(')) return false;
    std::size_t after = at + 2;
    std::vector<std::string_view> parameters;
    while (tokens_[after].kind == TokenKind::name && (tokens_[after + 1].is(',') || tokens_[after + 1].is(')'))) {
      parameters.push_back(tokens_[after].text);
      after += 2;
      if (tokens_[after - 1].is(')')) break;
    }
    if (parameters.empty() && tokens_[after].is(')')) ++after;
    if (!tokens_[after - 1].is(')') || !tokens_[after].is('=')) return false;
    if (find_function(tokens_[at].text) != nullptr)
      source_.fail(tokens_[at].at, fmt::format("'{}' is a function already", tokens_[at].text));
    const UserFunction made{parameters, after + 1, functions_.size()};
    if (!functions_.emplace(tokens_[at].text, made).second)
      source_.fail(tokens_[at].at, fmt::format("'{}' is defined twice", tokens_[at].text));
    // Try the body once, so that mistakes are told where they stand even in functions that nobody calls.
    Names trial;
    for (const std::string_view parameter : parameters) trial.emplace(parameter, Expression::x());
    at = after + 1;
    callable_ = made.order;
    expression(at, &trial);
    callable_ = ~std::size_t{0};
    return true;
  }

  Expression statement(std::size_t& at) {
    const bool binding = tokens_[at].kind == TokenKind::name && tokens_[at + 1].is('=');
    if (!binding) return expression(at, nullptr);
    const Token& name = tokens_[at];
    if (constant(name.text))
      source_.fail(name.at, fmt::format("'{}' has a meaning already and cannot be given another", name.text));
    at += 2;
    Expression value = expression(at, nullptr);
    names_.insert_or_assign(name.text, value);
    return value;
  }

  static std::optional<Expression> constant(std::string_view name) {
    if (name == "x") return Expression::x();
    if (name == "y") return Expression::y();
    if (name == "z") return Expression::z();
    if (name == "pi") return std::numbers::pi;
    if (name == "tau") return 2 * std::numbers::pi;
    if (name == "e") return std::numbers::e;
    return std::nullopt;
  }

  /// What waits for operands: an operator, a parenthesis, or a call with the arguments it has so far.
  struct Waiting {
    enum Kind : std::uint8_t { binary, unary, parenthesis, call } kind;
    std::uint8_t precedence;
    char sign;
    std::size_t token;
  };
  struct Argument {
    std::string_view name;  // empty where positional
    std::size_t token;
    Expression value;
    std::optional<std::string_view> words;
  };
  struct Call {
    std::size_t token;
    std::vector<Argument> arguments;
    std::string_view next_name;
    std::size_t next_token;
  };

  static std::uint8_t precedence(char sign) {
    switch (sign) {
      case '|': return 1;
      case '&': return 2;
      case '+':
      case '-': return 3;
      case '*':
      case '/': return 4;
      case '^': return 6;
      default: return 0;
    }
  }
  static constexpr std::uint8_t unary_precedence = 5;

  /// The expression that begins at token `at`; moves past it. `locals` are a function's parameters.
  Expression expression(std::size_t& at, const Names* locals) {
    std::vector<Expression> values;
    std::vector<Waiting> waiting;
    std::vector<Call> calls;
    const auto reduce = [&] {
      const Waiting top = waiting.back();
      waiting.pop_back();
      if (top.kind == Waiting::unary) {
        values.back() = Expression::make(Opcode::negate, values.back());
      } else {
        const Expression b = std::move(values.back());
        values.pop_back();
        values.back() = Expression::make(binary(top.sign), values.back(), b);
      }
      if (++operations_ > most_operations) source_.fail(tokens_[at].at, fmt::format("more than {} operations", most_operations));
    };
    const auto reduce_to_bracket = [&] {
      while (!waiting.empty() && waiting.back().kind <= Waiting::unary) reduce();
    };
    const auto begin_argument = [&] {
      Call& call = calls.back();
      call.next_name = {};
      call.next_token = at;
      if (tokens_[at].kind == TokenKind::name && tokens_[at + 1].is('=')) {
        call.next_name = tokens_[at].text;
        at += 2;
      }
    };
    const auto end_argument = [&] {
      Call& call = calls.back();
      const Token& first = tokens_[call.next_token + (call.next_name.empty() ? 0 : 2)];
      call.arguments.push_back({call.next_name, call.next_token, std::move(values.back()), {}});
      if (first.kind == TokenKind::words) call.arguments.back().words = first.text;
      values.pop_back();
    };
    const auto end_call = [&] {
      waiting.pop_back();
      values.push_back(apply_call(calls.back(), locals));
      calls.pop_back();
      ++at;
    };

    for (bool operand = true;;) {
      const Token& token = tokens_[at];
      if (operand) {
        if (token.kind == TokenKind::number) {
          values.emplace_back(token.number);
          ++at;
          operand = false;
        } else if (token.kind == TokenKind::words && !waiting.empty() && waiting.back().kind == Waiting::call &&
                   (tokens_[at + 1].is(',') || tokens_[at + 1].is(')'))) {
          values.emplace_back(0.0);  // in place of the words
          ++at;
          operand = false;
        } else if (token.kind == TokenKind::name && tokens_[at + 1].is('(')) {
          waiting.push_back({Waiting::call, 0, '(', at});
          calls.push_back({at, {}, {}, 0});
          at += 2;
          if (tokens_[at].is(')')) {
            end_call();
            operand = false;
          } else {
            begin_argument();
          }
        } else if (token.kind == TokenKind::name) {
          values.push_back(variable(at, locals));
          ++at;
          operand = false;
        } else if (token.is('(')) {
          waiting.push_back({Waiting::parenthesis, 0, '(', at++});
        } else if (token.is('-') && tokens_[at + 1].kind == TokenKind::number && !tokens_[at + 2].is('^')) {
          values.emplace_back(-tokens_[at + 1].number);
          at += 2;
          operand = false;
        } else if (token.is('-') || token.is('!')) {
          waiting.push_back({Waiting::unary, unary_precedence, '-', at++});
        } else if (token.is('+')) {
          ++at;
        } else {
          unexpected(at, "a value");
        }
        continue;
      }
      const std::uint8_t rank = token.kind == TokenKind::sign ? precedence(token.text[0]) : std::uint8_t{0};
      if (rank > 0) {
        const bool to_the_right = token.is('^');
        while (!waiting.empty() && waiting.back().kind <= Waiting::unary &&
               (waiting.back().precedence > rank || (waiting.back().precedence == rank && !to_the_right)))
          reduce();
        waiting.push_back({Waiting::binary, rank, token.text[0], at++});
        operand = true;
      } else if (token.is(')')) {
        reduce_to_bracket();
        if (waiting.empty()) unexpected(at, "an operator");
        if (waiting.back().kind == Waiting::call) {
          end_argument();
          end_call();
        } else {
          waiting.pop_back();
          ++at;
        }
      } else if (token.is(',')) {
        reduce_to_bracket();
        if (waiting.empty() || waiting.back().kind != Waiting::call) unexpected(at, "an operator");
        end_argument();
        ++at;
        begin_argument();
        operand = true;
      } else {
        reduce_to_bracket();
        if (!waiting.empty())
          source_.fail(tokens_[at].at,
                       fmt::format("the parenthesis opened at column {} is not closed", column(waiting.back().token)));
        if (token.kind != TokenKind::end && token.kind != TokenKind::end_of_statement) unexpected(at, "an operator");
        return std::move(values.back());
      }
    }
  }

  [[nodiscard]] std::size_t column(std::size_t token) const {
    const std::size_t at = tokens_[token].at, line = source_.text().substr(0, at).rfind('\n');
    return line == std::string_view::npos ? at + 1 : at - line;
  }

  static Opcode binary(char sign) {
    switch (sign) {
      case '+': return Opcode::add;
      case '-': return Opcode::subtract;
      case '*': return Opcode::multiply;
      case '/': return Opcode::divide;
      case '^': return Opcode::power;
      case '|': return Opcode::minimum;
      default: return Opcode::maximum;
    }
  }

  Expression variable(std::size_t at, const Names* locals) const {
    const std::string_view name = tokens_[at].text;
    if (locals != nullptr)
      if (const auto found = locals->find(name); found != locals->end()) return found->second;
    if (const auto value = constant(name)) return *value;
    if (const auto found = names_.find(name); found != names_.end()) return found->second;
    if (find_function(name) != nullptr || functions_.contains(name))
      source_.fail(tokens_[at].at, fmt::format("'{}' is a function: write {}(...)", name, name));
    std::vector<std::string_view> known{"x", "y", "z", "pi", "tau"};
    for (const auto& [other, value] : names_) known.push_back(other);
    source_.fail(tokens_[at].at, fmt::format("unknown name '{:.40}'{}", name, suggestion(name, known)));
  }

  Expression apply_call(const Call& call, const Names* /*locals*/) {
    const std::string_view name = tokens_[call.token].text;
    if (const auto user = functions_.find(name); user != functions_.end() && user->second.order < callable_) {
      const std::vector<std::string_view>& parameters = user->second.parameters;
      const Given given = arranged(call, parameters, false);
      Names bound;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!given.values[i])
          source_.fail(tokens_[call.token].at, fmt::format("'{}' lacks its argument '{}'", name, parameters[i]));
        if (given.words == i) source_.fail(tokens_[call.token].at, fmt::format("'{}' takes no words in quotes", name));
        bound.insert_or_assign(parameters[i], *given.values[i]);
      }
      constexpr int deepest = 100;
      if (depth_ >= deepest)
        source_.fail(tokens_[call.token].at, fmt::format("functions call each other more than {} deep", deepest));
      ++depth_;
      const std::size_t outer = std::exchange(callable_, user->second.order);
      std::size_t body = user->second.first;
      Expression value = expression(body, &bound);
      callable_ = outer;
      --depth_;
      return value;
    }
    const LibraryFunction* function = find_function(name);
    if (function == nullptr) {
      std::vector<std::string_view> known;
      for (const LibraryFunction& other : library()) known.push_back(other.name);
      for (const auto& [other, value] : functions_) known.push_back(other);
      source_.fail(tokens_[call.token].at, fmt::format("unknown function '{:.40}'{}", name, suggestion(name, known)));
    }
    std::vector<std::string_view> parameters;
    parameters.reserve(function->parameters.size());
    for (const Parameter& parameter : function->parameters) parameters.push_back(parameter.name);
    Given given = arranged(call, parameters, function->any_number);
    for (std::size_t i = 0; i < given.values.size(); ++i) {
      const Parameter& parameter = function->parameters[std::min(i, function->parameters.size() - 1)];
      if (given.values[i] && parameter.quantity == Quantity::angle) given.values[i] = *given.values[i] * (std::numbers::pi / 180);
      if (given.values[i] && (parameter.quantity == Quantity::text) != (given.words == i))
        source_.fail(tokens_[call.token].at,
                     fmt::format("'{}' of '{}' {}", parameter.name, name,
                                 given.words == i ? "is a number, not words in quotes" : "wants words in quotes"));
    }
    try {
      return frep::call(*function, given.values, given.text);
    } catch (const Error& error) {
      source_.fail(tokens_[call.token].at, error.what());
    }
  }

  /// Arguments in the order of the parameters; those that were left out are empty.
  struct Given {
    std::vector<std::optional<Expression>> values;
    std::size_t words = ~std::size_t{0};  ///< which of them are words
    std::string text;
  };
  Given arranged(const Call& call, const std::vector<std::string_view>& parameters, bool any_number) const {
    const std::string_view name = tokens_[call.token].text;
    Given given;
    given.values.resize(parameters.size());
    std::size_t next = 0;
    for (const Argument& argument : call.arguments) {
      std::size_t place = next;
      if (!argument.name.empty()) {
        place = 0;
        while (place < parameters.size() && parameters[place] != argument.name) ++place;
        if (place == parameters.size())
          source_.fail(tokens_[argument.token].at,
                       fmt::format("'{}' has no parameter '{:.40}'; it has: {}", name, argument.name,
                                   parameters.empty() ? "none" : fmt::format("{}", fmt::join(parameters, ", "))));
      } else {
        ++next;
      }
      if (place >= given.values.size()) {
        if (!any_number)
          source_.fail(tokens_[argument.token].at, fmt::format("'{}' takes at most {} argument{}", name, parameters.size(),
                                                               parameters.size() == 1 ? "" : "s"));
        given.values.emplace_back();
      }
      if (given.values[place])
        source_.fail(tokens_[argument.token].at,
                     fmt::format("the argument '{}' is given twice", place < parameters.size() ? parameters[place] : "?"));
      given.values[place] = argument.value;
      if (argument.words) given.words = place, given.text = unescaped(*argument.words);
    }
    return given;
  }

  /// "\n" is a new line.
  static std::string unescaped(std::string_view words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool new_line = words.substr(i, 2) == "\\n";
      text += new_line ? '\n' : words[i];
      i += new_line;
    }
    return text;
  }

  TextSource source_;
  std::vector<Token> tokens_;
  Names names_;
  std::unordered_map<std::string_view, UserFunction> functions_;
  std::size_t callable_ = ~std::size_t{0};  ///< user functions of lower order may be called
  std::size_t operations_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse_infix(std::string_view text, std::string_view name) { return InfixParser(text, name).parse(); }

std::string print_infix(const Expression& expression) {
  const Flat flat = flatten(expression);
  const std::size_t count = flat.order.size();
  std::vector<std::uint32_t> uses(count), height(count);
  for (const Flat::Entry& entry : flat.order) {
    if (info(entry.op).arity >= 1) ++uses[entry.a];
    if (info(entry.op).arity == 2) ++uses[entry.b];
  }
  // What is used more than once, and what would nest too deep to read, gets a name of its own.
  constexpr std::uint32_t deepest = 12;
  std::string out;
  std::vector<std::string> text(count);
  std::vector<bool> atom(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Flat::Entry& entry = flat.order[i];
    const OpcodeInfo& op = info(entry.op);
    const auto take = [&](std::uint32_t argument, bool bare) {
      std::string part = uses[argument] == 1 ? std::move(text[argument]) : text[argument];
      return bare || atom[argument] ? part : "(" + part + ")";
    };
    switch (op.arity) {
      case 0:
        text[i] = entry.op == Opcode::constant ? number_text(entry.constant) : std::string(op.infix);
        atom[i] = entry.op != Opcode::constant || entry.constant >= 0;
        break;
      case 1:
        height[i] = height[entry.a] + 1;
        atom[i] = entry.op != Opcode::negate;
        text[i] =
            entry.op == Opcode::negate ? "-(" + take(entry.a, true) + ")" : fmt::format("{}({})", op.infix, take(entry.a, true));
        break;
      default:
        height[i] = std::max(height[entry.a], height[entry.b]) + 1;
        if (op.infix.size() == 1) {
          text[i] = take(entry.a, false);
          text[i] += fmt::format(" {} {}", op.infix, take(entry.b, false));
        } else {
          text[i] = fmt::format("{}({}", op.infix, take(entry.a, true));
          text[i] += fmt::format(", {})", take(entry.b, true));
          atom[i] = true;
        }
    }
    if (op.arity > 0 && i + 1 < count && (uses[i] > 1 || height[i] >= deepest)) {
      const std::string bound = fmt::format("t{}", i);
      out += bound + " = " + text[i] + "\n";
      text[i] = bound;
      atom[i] = true;
      height[i] = 0;
    }
  }
  return out + text.back() + "\n";
}

}  // namespace fieldfab::frep
