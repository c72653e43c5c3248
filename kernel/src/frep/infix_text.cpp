// Infix .frep text: docs/frep-language.md is its manual. Precedence is resolved with stacks, so nesting costs memory only.
#include <array>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "fieldfab/core/text.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/frep/shapes.h"
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

/// What a name stands for.
struct Named : Value {
  bool part = false;  ///< what part(...) gives
};

using Names = std::unordered_map<std::string_view, Named>;

class InfixParser {
 public:
  InfixParser(std::string_view text, std::string_view name, const Opener& opener)
      : source_(text, name), tokens_(tokens_of(source_)), opener_(opener) {}

  std::vector<TextPart> parse() {
    std::optional<Named> result;
    std::optional<std::size_t> loose;  // where the last statement that gives its value no name begins
    for (std::size_t at = 0; tokens_[at].kind != TokenKind::end;) {
      if (tokens_[at].kind == TokenKind::end_of_statement) {
        ++at;
        continue;
      }
      if (loose)
        source_.fail(*loose, "this value is not used: give it a name, or make it a part with part(...); without parts the last "
                             "statement is the solid");
      const std::size_t first = at;
      if (!define_function(at)) {
        result = statement(at);
        if (!result->part && !tokens_[first + 1].is('=')) loose = tokens_[first].at;
      }
      if (tokens_[at].kind != TokenKind::end && tokens_[at].kind != TokenKind::end_of_statement)
        unexpected(at, "the end of the statement");
    }
    if (!parts_.empty()) {
      if (loose) source_.fail(*loose, "the text has parts, and this is none: make it one with part(...), or give it a name");
      return std::move(parts_);
    }
    if (!result) source_.fail(source_.text().size(), "the text has no result: its last statement is the solid");
    return {{result->expression, {}, {}}};
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
    for (const std::string_view parameter : parameters) trial.emplace(parameter, Named{{Expression::x()}});
    at = after + 1;
    callable_ = made.order;
    trial_ = true;
    expression(at, &trial);
    trial_ = false;
    callable_ = ~std::size_t{0};
    return true;
  }

  Named statement(std::size_t& at) {
    const bool binding = tokens_[at].kind == TokenKind::name && tokens_[at + 1].is('=');
    if (!binding) return expression(at, nullptr);
    const Token& name = tokens_[at];
    if (constant(name.text))
      source_.fail(name.at, fmt::format("'{}' has a meaning already and cannot be given another", name.text));
    at += 2;
    Named value = expression(at, nullptr);
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
    Named value;
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
  Named expression(std::size_t& at, const Names* locals) {
    std::vector<Named> values;
    std::vector<Waiting> waiting;
    std::vector<Call> calls;
    const auto reduce = [&] {
      const Waiting top = waiting.back();
      waiting.pop_back();
      if (top.kind == Waiting::unary) {
        values.back() = {{Expression::make(Opcode::negate, values.back().expression), values.back().solid}};
      } else {
        const Named b = std::move(values.back());
        values.pop_back();
        values.back() = joined(values.back(), b, top);
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
          values.push_back({{token.number}});
          ++at;
          operand = false;
        } else if (token.kind == TokenKind::words && !waiting.empty() && waiting.back().kind == Waiting::call &&
                   (tokens_[at + 1].is(',') || tokens_[at + 1].is(')'))) {
          values.push_back({{0.0}});  // in place of the words
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
          values.push_back({{-tokens_[at + 1].number}});
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

  [[nodiscard]] Named joined(const Named& a, const Named& b, const Waiting& by) const {
    try {
      return {frep::joined(by.sign, a, b)};
    } catch (const Error& error) {
      source_.fail(tokens_[by.token].at, error.what());
    }
  }

  Named variable(std::size_t at, const Names* locals) const {
    const std::string_view name = tokens_[at].text;
    if (locals != nullptr)
      if (const auto found = locals->find(name); found != locals->end()) return found->second;
    if (const auto value = constant(name)) return {{*value}};
    if (const auto found = names_.find(name); found != names_.end()) return found->second;
    if (find_function(name) != nullptr || functions_.contains(name))
      source_.fail(tokens_[at].at, fmt::format("'{}' is a function: write {}(...)", name, name));
    std::vector<std::string_view> known{"x", "y", "z", "pi", "tau"};
    for (const auto& [other, value] : names_) known.push_back(other);
    source_.fail(tokens_[at].at, fmt::format("unknown name '{:.40}'{}", name, suggestion(name, known)));
  }

  Named apply_call(const Call& call, const Names* /*locals*/) {
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
      Named value = expression(body, &bound);
      callable_ = outer;
      --depth_;
      return value;
    }
    if (name == "open") return opened(call);
    if (name == "part") return made_part(call);
    const LibraryFunction* function = find_function(name);
    if (function == nullptr) {
      std::vector<std::string_view> known{"open", "part"};
      for (const LibraryFunction& other : library()) known.push_back(other.name);
      for (const auto& [other, value] : functions_) known.push_back(other);
      source_.fail(tokens_[call.token].at, fmt::format("unknown function '{:.40}'{}", name, suggestion(name, known)));
    }
    std::vector<std::string_view> parameters;
    parameters.reserve(function->parameters.size());
    for (const Parameter& parameter : function->parameters) parameters.push_back(parameter.name);
    const Given given = arranged(call, parameters, function->any_number);
    std::vector<std::optional<Value>> values(given.values.size());
    for (std::size_t i = 0; i < given.values.size(); ++i) {
      const Parameter& parameter = function->parameters[std::min(i, function->parameters.size() - 1)];
      if (!given.values[i]) continue;
      values[i] = *given.values[i];
      if (parameter.quantity == Quantity::angle) values[i]->expression = values[i]->expression * (std::numbers::pi / 180);
      if ((parameter.quantity == Quantity::text) != (given.words == i))
        source_.fail(tokens_[call.token].at,
                     fmt::format("'{}' of '{}' {}", parameter.name, name,
                                 given.words == i ? "is a number, not words in quotes" : "wants words in quotes"));
    }
    try {
      return {frep::call(*function, values, given.text)};
    } catch (const Error& error) {
      source_.fail(tokens_[call.token].at, error.what());
    }
  }

  /// open("scan.nrrd", threshold = 300): a file's solid.
  Named opened(const Call& call) const {
    const std::size_t at = tokens_[call.token].at;
    std::string path;
    std::vector<OpenOption> options;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const Argument& argument = call.arguments[i];
      if (i == 0 && argument.words && argument.name.empty()) {
        path = *argument.words;
        continue;
      }
      if (i == 0 || argument.name.empty()) source_.fail(tokens_[argument.token].at, "expected open(\"FILE\", NAME = VALUE, ...)");
      const Expression value = simplify(argument.value.expression);
      if (!argument.words && value.opcode() != Opcode::constant)
        source_.fail(tokens_[argument.token].at, fmt::format("'{}' of 'open' must be a plain number or words", argument.name));
      if (argument.words)
        options.push_back({std::string(argument.name), std::string(*argument.words)});
      else
        options.push_back({std::string(argument.name), value.constant()});
    }
    if (path.empty()) source_.fail(at, "'open' lacks the name of a file in quotes");
    if (trial_) return {{Expression::x(), true}};
    if (!opener_) source_.fail(at, "files cannot be opened from this text");
    try {
      return {{opener_(path, options), true}};
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::internal) throw;
      throw Error(error.kind(), source_.place(at), error.what());
    }
  }

  /// part(SHAPE, "NAME", "COLOUR"): one of the solids that the text makes.
  Named made_part(const Call& call) {
    static constexpr std::array<std::string_view, 3> parameters{"shape", "name", "colour"};
    std::array<const Argument*, 3> given{};
    std::size_t next = 0;
    for (const Argument& argument : call.arguments) {
      std::size_t place = argument.name.empty() ? next++ : 0;
      if (!argument.name.empty()) {
        const std::string_view name = argument.name == "color" ? "colour" : argument.name;
        while (place < parameters.size() && parameters[place] != name) ++place;
      }
      if (place >= parameters.size() || given[place] != nullptr || argument.words.has_value() != (place > 0))
        source_.fail(tokens_[argument.token].at, "expected part(SHAPE, \"NAME\", \"COLOUR\")");
      given[place] = &argument;
    }
    const std::size_t at = tokens_[call.token].at;
    if (given[0] == nullptr || given[1] == nullptr || given[1]->words->empty())
      source_.fail(at, "'part' lacks its shape or its name: part(SHAPE, \"NAME\", \"COLOUR\")");
    TextPart part{given[0]->value.expression, std::string(*given[1]->words), {}};
    if (given[2] != nullptr) {
      try {
        part.colour = colour_named(*given[2]->words);
      } catch (const Error& error) {
        source_.fail(tokens_[given[2]->token].at, error.what());
      }
    }
    const Named value{{part.shape, true}, true};
    if (trial_) return value;
    for (const TextPart& other : parts_)
      if (other.name == part.name) source_.fail(at, fmt::format("two parts are called '{:.60}'", part.name));
    parts_.push_back(std::move(part));
    return value;
  }

  /// Arguments in the order of the parameters; those that were left out are empty.
  struct Given {
    std::vector<std::optional<Named>> values;
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
  const Opener& opener_;
  Names names_;
  std::vector<TextPart> parts_;
  bool trial_ = false;  ///< nothing is opened, and no part is made
  std::unordered_map<std::string_view, UserFunction> functions_;
  std::size_t callable_ = ~std::size_t{0};  ///< user functions of lower order may be called
  std::size_t operations_ = 0;
  int depth_ = 0;
};

}  // namespace

std::vector<TextPart> parse_parts(std::string_view text, std::string_view name, const Opener& opener) {
  return InfixParser(text, name, opener).parse();
}

Expression parse_infix(std::string_view text, std::string_view name, const Opener& opener) {
  const std::vector<TextPart> parts = parse_parts(text, name, opener);
  Expression all = parts.front().shape;
  for (std::size_t i = 1; i < parts.size(); ++i) all = Expression::make(Opcode::minimum, all, parts[i].shape);
  return all;
}

namespace {

/// An expression as binding lines, and what the last of them is made from.
struct Printed {
  std::string bindings, result;
};

std::string text_of(const Source& source, const std::filesystem::path& folder) {
  if (source.path.empty())
    throw Error(ErrorKind::bad_input, "", "a solid that was made in memory has no text: save it as a file, and open that");
  std::filesystem::path path = source.path;
  if (!folder.empty())
    if (const auto inner = path.lexically_relative(folder); !inner.empty() && *inner.begin() != "..") path = inner;
  const std::string name = path.generic_string();
  if (name.find_first_of("\"\n") != std::string::npos)
    throw Error(ErrorKind::bad_input, name, "a name with quotes or line ends cannot stand in a text");
  return fmt::format("open(\"{}\"{}{})", name, source.options.empty() ? "" : ", ", source.options);
}

Printed printed(const Expression& expression, const std::filesystem::path& folder) {
  const Flat flat = flatten(expression);
  const std::size_t count = flat.order.size();
  std::vector<std::uint32_t> uses(count), height(count);
  for (const Flat::Entry& entry : flat.order) {
    if (info(entry.op).arity >= 1) ++uses[entry.a];
    if (info(entry.op).arity >= 2) ++uses[entry.b];
    if (info(entry.op).arity == 3) ++uses[entry.c];
  }
  // What is used more than once, and what would nest too deep to read, gets a name of its own.
  constexpr std::uint32_t deepest = 12;
  std::string bindings;
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
      case 3: {
        height[i] = std::max({height[entry.a], height[entry.b], height[entry.c]}) + 1;
        atom[i] = true;
        const std::string file = text_of(*entry.source, folder), x = take(entry.a, true), y = take(entry.b, true);
        const std::string z = take(entry.c, true);
        text[i] = x == "x" && y == "y" && z == "z" ? fmt::format("value({})", file)
                                                   : fmt::format("value(map({}, {}, {}, {}))", file, x, y, z);
        break;
      }
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
      bindings += bound + " = " + text[i] + "\n";
      text[i] = bound;
      atom[i] = true;
      height[i] = 0;
    }
  }
  return {std::move(bindings), std::move(text.back())};
}

}  // namespace

std::string print_infix(const Expression& expression, const std::filesystem::path& folder) {
  const Printed all = printed(expression, folder);
  return all.bindings + all.result + "\n";
}

std::string print_parts(std::span<const TextPart> parts, const std::filesystem::path& folder) {
  std::string out;
  for (const TextPart& part : parts) {
    const Printed shape = printed(part.shape, folder);
    std::string name = part.name.empty() && parts.size() > 1 ? fmt::format("part {}", &part - parts.data() + 1) : part.name;
    for (char& c : name)
      if (c == '"' || c == '\n') c = '\'';
    const std::string colour = part.colour ? fmt::format(", \"{}\"", text_of(*part.colour)) : "";
    out += shape.bindings + (name.empty() ? shape.result : fmt::format("part({}, \"{}\"{})", shape.result, name, colour)) + "\n";
  }
  return out;
}

}  // namespace fieldfab::frep
