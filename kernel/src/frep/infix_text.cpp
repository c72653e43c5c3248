// Infix .frep text; its manual is docs/frep-language.md. Precedence is resolved with explicit
// stacks, so nesting costs memory only.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "fieldfab/core/angle.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/frep/shapes.h"
#include "lexer.h"
#include "text_source.h"

namespace fieldfab::frep {
namespace {

/// A token with the context that the parser needs. Comments are left out; line ends outside
/// parentheses are tokens.
struct InfixToken {
  enum Kind : std::uint8_t { number, name, words, unclosed_words, sign, unknown, end_of_statement, end } kind;
  bool unindented;  ///< the first token of its line
  std::size_t at;
  std::string_view text;  ///< of words: the text between the quotes
  [[nodiscard]] bool is(char c) const { return kind == sign && text[0] == c; }
  [[nodiscard]] bool ends() const { return kind == end_of_statement || kind == end; }
  [[nodiscard]] std::size_t length() const { return text.size() + (kind == words ? 2 : 0); }
};

/// Value of a name.
struct Named : Value {
  bool part = false;  ///< whether part(...) made it
  /// Result of an invalid definition, or parameter during the trial of a function: fits everywhere.
  bool unknown = false;
};

using Names = std::unordered_map<std::string_view, Named>;

Named unknown_value() { return {{Expression::x()}, false, true}; }

class InfixParser {
 public:
  /// Appends errors to `found` if it is not null, and throws them otherwise.
  InfixParser(std::string_view text, std::string_view name, const Opener& opener,
              std::vector<Diagnostic>* found = nullptr)
      : source_(text, name), opener_(opener), found_(found) {
    read_tokens(0);
  }

  std::vector<TextPart> parse() {
    std::optional<Named> result;
    std::optional<std::size_t> loose;  // start of the last statement without a name for its value
    for (std::size_t at = 0; tokens_[at].kind != InfixToken::end && !full();) {
      if (tokens_[at].kind == InfixToken::end_of_statement) {
        ++at;
        continue;
      }
      if (loose)
        report(*std::exchange(loose, std::nullopt),
               "this value is not used: give it a name, or make it a part with part(...); without parts the last "
               "statement is "
               "the solid");
      const std::size_t first = at;
      try {
        if (!define_function(at)) {
          result = statement(at);
          if (!result->part && !tokens_[first + 1].is('=')) loose = tokens_[first].at;
        }
        if (!tokens_[at].ends()) unexpected(at, "the end of the statement");
      } catch (const TextError& error) {
        report(error);
        go_on_after(first, at);
        loose.reset();
        result = unknown_value();
      }
    }
    if (!parts_.empty()) {
      if (loose) report(*loose, "the text has parts, and this is none: make it one with part(...), or give it a name");
      return std::move(parts_);
    }
    if (!result) report(source_.text().size(), "the text has no result: its last statement is the solid");
    return {{result.value_or(unknown_value()).expression, {}, {}, {}}};
  }

 private:
  struct UserFunction {
    std::vector<std::string_view> parameters;
    std::size_t first;     // first token of the body
    std::size_t order;     // functions may call only those defined before them
    bool unknown = false;  // the body is invalid
  };

  /// Reads the tokens from byte `from` on, outside parentheses.
  void read_tokens(std::size_t from) {
    const std::string_view text = source_.text();
    Lexer lexer(text, from);
    int open = 0;  // depth of parentheses, inside which a statement continues over line ends
    std::size_t line = 1, end = from;
    while (const std::optional<Token> token = lexer.next()) {
      if (token->kind == TokenKind::comment) continue;
      if (token->line != line && open == 0 && end != from)
        tokens_.push_back({InfixToken::end_of_statement, false, end, {}});
      line = token->line;
      end = token->offset + token->length;
      const std::string_view shown = text.substr(token->offset, token->length);
      const auto add = [&](InfixToken::Kind kind, std::string_view as) {
        tokens_.push_back({kind, token->column == 1, token->offset, as});
      };
      switch (token->kind) {
        case TokenKind::number: add(InfixToken::number, shown); break;
        case TokenKind::name: add(InfixToken::name, shown); break;
        case TokenKind::string:
          if (is_closed(shown))
            add(InfixToken::words, shown.substr(1, shown.size() - 2));
          else
            add(InfixToken::unclosed_words, shown);
          break;
        case TokenKind::sign:
          open = shown == "(" ? open + 1 : shown == ")" ? std::max(open - 1, 0) : shown == ";" ? 0 : open;
          add(shown == ";" ? InfixToken::end_of_statement : InfixToken::sign, shown);
          break;
        default: add(InfixToken::unknown, shown);
      }
    }
    if (open == 0 && text.find('\n', end) != std::string_view::npos)
      tokens_.push_back({InfixToken::end_of_statement, false, end, {}});
    tokens_.push_back({InfixToken::end, false, end, {}});
  }

  // Recovery after errors.

  void report(const TextError& error) {
    if (found_ == nullptr) throw TextError(error);
    const std::string_view text = source_.text();
    const std::size_t at = std::min(error.at, text.size());
    const auto known = [&](const Diagnostic& other) { return other.offset == at && other.message == error.message; };
    if (std::ranges::any_of(*found_, known)) return;  // in the body of a function that is called again
    const auto token = std::ranges::lower_bound(tokens_, at, {}, &InfixToken::at);
    const std::size_t length = token != tokens_.end() && token->at == at ? token->length() : 0;
    const std::string_view before = text.substr(0, at);
    const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    found_->push_back({at, length, lines + 1, at - (before.rfind('\n') + 1) + 1, error.message});
  }
  void report(std::size_t at, const std::string& message) {
    report(TextError(ErrorKind::bad_input, source_.place(at), message, at));
  }

  /// Whether the search for further errors has ended.
  [[nodiscard]] bool full() const {
    constexpr std::size_t most = 100;
    return found_ != nullptr && (found_->size() >= most || operations_ > most_operations);
  }

  /// Makes the name that a statement defines unknown, and moves past the statement. A statement
  /// with an open parenthesis ends before a line that is not indented and looks like the next
  /// statement.
  void go_on_after(std::size_t first, std::size_t& at) {
    trial_ = false;
    callable_ = ~std::size_t{0};
    depth_ = 0;
    const std::string_view name = tokens_[first].text;
    if (tokens_[first].kind == InfixToken::name && tokens_[first + 1].is('='))
      names_.insert_or_assign(name, unknown_value());
    if (const auto made = functions_.find(name); made != functions_.end() && made->second.first > first)
      made->second.unknown = true;
    const auto begins_statement = [&] {
      const InfixToken& token = tokens_[at];
      if (at == first || token.kind != InfixToken::name || !token.unindented || tokens_[at - 1].is(',')) return false;
      return tokens_[at + 1].is('=') || tokens_[at - 1].is(')') || tokens_[at - 1].kind != InfixToken::sign;
    };
    while (!tokens_[at].ends() && !begins_statement()) ++at;
    if (tokens_[at].ends()) return;
    const std::size_t next = tokens_[at].at;
    tokens_.resize(at);
    read_tokens(next);
  }

  /// Fails at a token that fits nowhere.
  void refuse_alone(std::size_t at) const {
    const InfixToken& token = tokens_[at];
    if (token.kind == InfixToken::unclosed_words)
      source_.fail(token.at, "the quotes opened here are not closed on this line");
    if (token.kind == InfixToken::unknown)
      source_.fail(token.at, fmt::format("unexpected {}", source_.shown(token.at)));
    if (token.kind == InfixToken::name && at > 0 && tokens_[at - 1].kind == InfixToken::number &&
        tokens_[at - 1].at + tokens_[at - 1].length() == token.at)
      source_.fail(token.at, fmt::format("unexpected {} after a number", source_.shown(token.at)));
  }

  [[noreturn]] void unexpected(std::size_t at, const char* expected) const {
    refuse_alone(at);
    const InfixToken& token = tokens_[at];
    const std::string found = token.kind == InfixToken::end                ? "the end of the text"
                              : token.kind == InfixToken::end_of_statement ? "the end of the line"
                                                                           : fmt::format("'{:.40}'", token.text);
    source_.fail(token.at, fmt::format("expected {}, found {}", expected, found));
  }

  [[nodiscard]] double number(std::size_t token) const {
    std::size_t at = tokens_[token].at;
    return source_.number(at);
  }

  /// Reads `name(a, b) = ...`; moves past it.
  bool define_function(std::size_t& at) {
    if (tokens_[at].kind != InfixToken::name || !tokens_[at + 1].is('(')) return false;
    std::size_t after = at + 2;
    std::vector<std::string_view> parameters;
    while (tokens_[after].kind == InfixToken::name && (tokens_[after + 1].is(',') || tokens_[after + 1].is(')'))) {
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
    // Evaluate the body once, so that errors are reported at their place even in functions that are
    // never called.
    Names trial;
    for (const std::string_view parameter : parameters) trial.emplace(parameter, unknown_value());
    at = after + 1;
    callable_ = made.order;
    trial_ = true;
    expression(at, &trial);
    trial_ = false;
    callable_ = ~std::size_t{0};
    return true;
  }

  Named statement(std::size_t& at) {
    const bool binding = tokens_[at].kind == InfixToken::name && tokens_[at + 1].is('=');
    if (!binding) return expression(at, nullptr);
    const InfixToken& name = tokens_[at];
    if (find_constant(name.text) != nullptr)
      source_.fail(name.at, fmt::format("'{}' has a meaning already and cannot be given another", name.text));
    at += 2;
    Named value = expression(at, nullptr);
    names_.insert_or_assign(name.text, value);
    return value;
  }

  /// An element that waits for operands: an operator, a parenthesis, or a call with its arguments
  /// so far.
  struct Waiting {
    enum Kind : std::uint8_t { binary, unary, parenthesis, call } kind;
    std::uint8_t precedence;
    char sign;
    std::size_t token;
  };
  struct Argument {
    std::string_view name;  // empty if positional
    std::size_t token;
    Named value;
    std::optional<std::string> words;
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

  /// Reads the expression at token `at`; moves past it. `locals` are a function's parameters.
  Named expression(std::size_t& at, const Names* locals) { return ExpressionReader(*this, at, locals).read(); }

  /// Reads an expression by the shunting-yard algorithm, without recursion: expressions may be as deep as they are
  /// long.
  class ExpressionReader {
   public:
    /// Moves `at` to the token after the expression.
    ExpressionReader(InfixParser& parser, std::size_t& at, const Names* locals)
        : parser_(parser), tokens_(parser.tokens_), at_(at), locals_(locals) {}

    Named read() {
      Next next = Next::operand;
      while (next != Next::end) next = next == Next::operand ? operand() : operation();
      return std::move(values_.back());
    }

   private:
    enum class Next : std::uint8_t { operand, operation, end };

    Next operand() {
      const InfixToken& token = tokens_[at_];
      if (token.kind == InfixToken::number) return push({{parser_.number(at_)}}, 1);
      if (token.kind == InfixToken::words && is_argument()) return push({{0.0}}, 1);  // in place of the words
      if (token.kind == InfixToken::name && tokens_[at_ + 1].is('(')) return begin_call();
      if (token.kind == InfixToken::name) return push(parser_.variable(at_, locals_), 1);
      if (token.is('-') && tokens_[at_ + 1].kind == InfixToken::number && !tokens_[at_ + 2].is('^'))
        return push({{-parser_.number(at_ + 1)}}, 2);
      if (token.is('('))
        waiting_.push_back({Waiting::parenthesis, 0, '(', at_++});
      else if (token.is('-') || token.is('!'))
        waiting_.push_back({Waiting::unary, unary_precedence, '-', at_++});
      else if (token.is('+'))
        ++at_;
      else
        parser_.unexpected(at_, "a value");
      return Next::operand;
    }

    Next push(Named value, std::size_t tokens) {
      values_.push_back(std::move(value));
      at_ += tokens;
      return Next::operation;
    }

    /// Whether a token is all of an argument of a call.
    [[nodiscard]] bool is_argument() const {
      return !waiting_.empty() && waiting_.back().kind == Waiting::call &&
             (tokens_[at_ + 1].is(',') || tokens_[at_ + 1].is(')'));
    }

    Next operation() {
      const InfixToken& token = tokens_[at_];
      const std::uint8_t rank = token.kind == InfixToken::sign ? precedence(token.text[0]) : std::uint8_t{0};
      if (rank > 0) {
        const bool to_the_right = token.is('^');
        while (!waiting_.empty() && waiting_.back().kind <= Waiting::unary &&
               (waiting_.back().precedence > rank || (waiting_.back().precedence == rank && !to_the_right)))
          reduce();
        waiting_.push_back({Waiting::binary, rank, token.text[0], at_++});
        return Next::operand;
      }
      while (!waiting_.empty() && waiting_.back().kind <= Waiting::unary) reduce();
      if (token.is(')')) return close_bracket();
      if (token.is(',')) return next_argument();
      parser_.refuse_alone(at_);
      if (!waiting_.empty())
        parser_.source_.fail(tokens_[at_].at, fmt::format("the parenthesis opened at column {} is not closed",
                                                          parser_.column(waiting_.back().token)));
      if (!token.ends()) parser_.unexpected(at_, "an operator");
      return Next::end;
    }

    /// Applies the last operator that waits.
    void reduce() {
      const Waiting top = waiting_.back();
      waiting_.pop_back();
      if (top.kind == Waiting::unary) {
        values_.back().expression = Expression::make(Opcode::negate, values_.back().expression);
        values_.back().part = false;
      } else {
        const Named b = std::move(values_.back());
        values_.pop_back();
        values_.back() = parser_.joined(values_.back(), b, top);
      }
      if (++parser_.operations_ > most_operations)
        parser_.source_.fail(tokens_[at_].at, fmt::format("more than {} operations", most_operations));
    }

    Next close_bracket() {
      if (waiting_.empty()) parser_.unexpected(at_, "an operator");
      if (waiting_.back().kind == Waiting::call) {
        end_argument();
        return end_call();
      }
      waiting_.pop_back();
      ++at_;
      return Next::operation;
    }

    Next begin_call() {
      waiting_.push_back({Waiting::call, 0, '(', at_});
      calls_.push_back({at_, {}, {}, 0});
      at_ += 2;
      if (tokens_[at_].is(')')) return end_call();
      begin_argument();
      return Next::operand;
    }

    void begin_argument() {
      Call& call = calls_.back();
      call.next_name = {};
      call.next_token = at_;
      if (tokens_[at_].kind == InfixToken::name && tokens_[at_ + 1].is('=')) {
        call.next_name = tokens_[at_].text;
        at_ += 2;
      }
    }

    Next next_argument() {
      if (waiting_.empty() || waiting_.back().kind != Waiting::call) parser_.unexpected(at_, "an operator");
      end_argument();
      ++at_;
      begin_argument();
      return Next::operand;
    }

    void end_argument() {
      Call& call = calls_.back();
      const InfixToken& first = tokens_[call.next_token + (call.next_name.empty() ? 0 : 2)];
      call.arguments.push_back({call.next_name, call.next_token, std::move(values_.back()), {}});
      if (first.kind == InfixToken::words) call.arguments.back().words = unquoted(first.text);
      values_.pop_back();
    }

    Next end_call() {
      waiting_.pop_back();
      values_.push_back(parser_.apply_call(calls_.back()));
      calls_.pop_back();
      ++at_;
      return Next::operation;
    }

    InfixParser& parser_;
    const std::vector<InfixToken>& tokens_;
    std::size_t& at_;
    const Names* locals_;
    std::vector<Named> values_;
    std::vector<Waiting> waiting_;
    std::vector<Call> calls_;
  };

  [[nodiscard]] std::size_t column(std::size_t token) const {
    const std::size_t at = tokens_[token].at, line = source_.text().substr(0, at).rfind('\n');
    return line == std::string_view::npos ? at + 1 : at - line;
  }

  [[nodiscard]] Named joined(const Named& a, const Named& b, const Waiting& by) const {
    if (a.unknown || b.unknown) return unknown_value();
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
    if (const Constant* constant = find_constant(name)) return {{constant->value}};
    if (const auto found = names_.find(name); found != names_.end()) return found->second;
    if (find_function(name) != nullptr || functions_.contains(name))
      source_.fail(tokens_[at].at, fmt::format("'{}' is a function: write {}(...)", name, name));
    std::vector<std::string_view> known{"x", "y", "z", "pi", "tau"};
    for (const auto& [other, value] : names_) known.push_back(other);
    source_.fail(tokens_[at].at, fmt::format("unknown name '{:.40}'{}", name, suggestion(name, known)));
  }

  Named apply_call(const Call& call) {
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
      if (user->second.unknown) return unknown_value();
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
      if (parameter.quantity == Quantity::angle) values[i]->expression = values[i]->expression * radians_per_degree;
      if ((parameter.quantity == Quantity::text) != (given.words == i))
        source_.fail(tokens_[call.token].at,
                     fmt::format("'{}' of '{}' {}", parameter.name, name,
                                 given.words == i ? "is a number, not words in quotes" : "wants words in quotes"));
    }
    if (std::any_of(given.values.begin(), given.values.end(),
                    [](const auto& value) { return value && value->unknown; }))
      return unknown_value();
    try {
      return {frep::call(*function, values, given.text)};
    } catch (const Error& error) {
      source_.fail(tokens_[call.token].at, error.what());
    }
  }

  /// open("scan.nrrd", threshold = 300): the solid of a file.
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
      if (i == 0 || argument.name.empty())
        source_.fail(tokens_[argument.token].at, "expected open(\"FILE\", NAME = VALUE, ...)");
      const Expression value = simplify(argument.value.expression);
      if (!argument.words && !argument.value.unknown && value.opcode() != Opcode::constant)
        source_.fail(tokens_[argument.token].at,
                     fmt::format("'{}' of 'open' must be a plain number or words", argument.name));
      if (argument.words)
        options.push_back({std::string(argument.name), *argument.words});
      else if (!argument.value.unknown)
        options.push_back({std::string(argument.name), value.constant()});
    }
    if (path.empty()) source_.fail(at, "'open' lacks the name of a file in quotes");
    if (trial_ ||
        std::any_of(call.arguments.begin(), call.arguments.end(), [](const Argument& a) { return a.value.unknown; }))
      return unknown_value();
    if (!opener_) source_.fail(at, "files cannot be opened from this text");
    try {
      return {{opener_(path, options), true}};
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::internal) throw;
      source_.fail(at, error.what(), error.kind());
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
    TextPart part{given[0]->value.expression, *given[1]->words, {}, source_.place(at)};
    if (given[2] != nullptr) {
      try {
        part.colour = colour_named(*given[2]->words);
      } catch (const Error& error) {
        source_.fail(tokens_[given[2]->token].at, error.what());
      }
    }
    Named value{{part.shape, true}, true, given[0]->value.unknown};
    if (trial_) return value;
    for (const TextPart& other : parts_)
      if (other.name == part.name) source_.fail(at, fmt::format("two parts are called '{:.60}'", part.name));
    parts_.push_back(std::move(part));
    return value;
  }

  /// Arguments in the order of the parameters; omitted ones are empty.
  struct Given {
    std::vector<std::optional<Named>> values;
    std::size_t words = ~std::size_t{0};  ///< index of the argument that is words
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
          source_.fail(tokens_[argument.token].at, fmt::format("'{}' takes at most {} {}", name, parameters.size(),
                                                               parameters.size() == 1 ? "argument" : "arguments"));
        given.values.emplace_back();
      }
      if (given.values[place])
        source_.fail(tokens_[argument.token].at, fmt::format("the argument '{}' is given twice",
                                                             place < parameters.size() ? parameters[place] : "?"));
      given.values[place] = argument.value;
      if (argument.words) given.words = place, given.text = *argument.words;
    }
    return given;
  }

  /// Replaces \n by a new line, \" by quotes and \\ by a backslash; keeps any other backslash.
  static std::string unquoted(std::string_view words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const char next = words[i] == '\\' && i + 1 < words.size() ? words[i + 1] : '\0';
      const bool escape = next == 'n' || next == '"' || next == '\\';
      text += !escape ? words[i] : next == 'n' ? '\n' : next;
      i += escape;
    }
    return text;
  }

  TextSource source_;
  std::vector<InfixToken> tokens_;
  const Opener& opener_;
  std::vector<Diagnostic>* found_;
  Names names_;
  std::vector<TextPart> parts_;
  bool trial_ = false;  ///< trial of a function: opens no file and makes no part
  std::unordered_map<std::string_view, UserFunction> functions_;
  std::size_t callable_ = ~std::size_t{0};  ///< user functions of lower order may be called
  std::size_t operations_ = 0;
  int depth_ = 0;
};

}  // namespace

std::vector<TextPart> parse_parts(std::string_view text, std::string_view name, const Opener& opener) {
  return InfixParser(text, name, opener).parse();
}

std::vector<Diagnostic> diagnostics(std::string_view text, const Opener& opener) {
  std::vector<Diagnostic> found;
  InfixParser(text, "", opener, &found).parse();
  return found;
}

Expression parse_infix(std::string_view text, std::string_view name, const Opener& opener) {
  const std::vector<TextPart> parts = parse_parts(text, name, opener);
  Expression all = parts.front().shape;
  for (std::size_t i = 1; i < parts.size(); ++i) all = Expression::make(Opcode::minimum, all, parts[i].shape);
  return all;
}

}  // namespace fieldfab::frep
