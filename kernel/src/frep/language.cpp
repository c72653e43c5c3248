#include "fieldfab/frep/language.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/library.h"
#include "lexer.h"

namespace fieldfab::frep {
namespace {

const Word open_word{"open", WordKind::function, "open(\"FILE\", NAME = VALUE, …)",
                     "the solid of a file that Fieldfab reads", "open(\"scan.nrrd\", threshold = 300)"};
const Word part_word{"part", WordKind::function, "part(SHAPE, \"NAME\", \"COLOUR\")",
                     "makes a solid a named part of the model", "part(sphere(5), \"ball\", \"tomato\")"};

Word word_of(const LibraryFunction& function) {
  return {std::string(function.name), WordKind::function, signature(function), meaning(function),
          std::string(function.example)};
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool begins(std::string_view name, std::string_view start) {
  return name.size() >= start.size() && std::ranges::equal(name.substr(0, start.size()), start, {}, lower, lower);
}

/// A definition in a text. Token numbers do not count comments.
struct Definition {
  std::string_view name;
  std::optional<std::vector<std::string_view>> parameters;  ///< of a function
  std::size_t first, body, end;  ///< tokens: the name, the first of the value, the one after the value
};

/// Tokens and statements of a text. A statement with an open parenthesis ends before a line that
/// begins with `name =`, is not indented and does not follow a comma; so a text keeps its
/// definitions while it is edited.
class Statements {
 public:
  explicit Statements(std::string_view text) : text_(text) {
    for (const Token& token : tokens(text)) (token.kind == TokenKind::comment ? comments_ : tokens_).push_back(token);
    std::size_t first = 0;
    int open = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (i > first && begins_statement(i, open)) {
        add_statement(first, i);
        first = i;
        open = 0;
      }
      if (is(i, "(")) ++open;
      if (is(i, ")") && open > 0) --open;
      if (is(i, ";")) open = 0;
    }
    add_statement(first, tokens_.size());
  }

  [[nodiscard]] std::size_t size() const { return tokens_.size(); }
  [[nodiscard]] const Token& operator[](std::size_t i) const { return tokens_[i]; }
  [[nodiscard]] const std::vector<Token>& comments() const { return comments_; }
  [[nodiscard]] std::string_view shown(const Token& token) const { return text_.substr(token.offset, token.length); }
  [[nodiscard]] bool is(std::size_t i, std::string_view sign) const { return i < size() && shown(tokens_[i]) == sign; }
  [[nodiscard]] bool is_name(std::size_t i) const { return i < size() && tokens_[i].kind == TokenKind::name; }
  [[nodiscard]] const std::vector<Definition>& definitions() const { return definitions_; }

  /// First token of the statement with token i; also for the end of the text.
  [[nodiscard]] std::size_t statement_of(std::size_t i) const {
    return *std::prev(std::ranges::upper_bound(statements_, i));
  }

  /// Number of tokens before an offset.
  [[nodiscard]] std::size_t before(std::size_t offset) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(tokens_, offset, {}, &Token::offset) - tokens_.begin());
  }

  [[nodiscard]] Word word_of(const Definition& made) const {
    const std::size_t start = tokens_[made.first].offset;
    std::string_view line = text_.substr(start, text_.find('\n', start) - start);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    const std::string signature =
        made.parameters ? fmt::format("{}({})", made.name, fmt::join(*made.parameters, ", ")) : "";
    return {std::string(made.name), WordKind::variable, made.parameters ? signature : std::string(made.name),
            printable(line), ""};
  }

 private:
  [[nodiscard]] bool begins_statement(std::size_t i, int open) const {
    if (is(i - 1, ";")) return true;
    if (tokens_[i].line == tokens_[i - 1].line) return false;
    return open == 0 || (tokens_[i].column == 1 && is_name(i) && is(i + 1, "=") && !is(i - 1, ","));
  }

  void add_statement(std::size_t first, std::size_t end) {
    statements_.push_back(first);
    if (end > first && is(end - 1, ";")) --end;
    if (end <= first || !is_name(first)) return;
    std::size_t after = first + 1;
    std::optional<std::vector<std::string_view>> parameters;
    if (is(after, "(")) {
      parameters.emplace();
      for (++after; is_name(after); ++after) {
        parameters->push_back(shown(tokens_[after]));
        if (!is(++after, ",")) break;
      }
      if (!is(after++, ")")) return;
    }
    if (after < end && is(after, "="))
      definitions_.push_back({shown(tokens_[first]), parameters, first, after + 1, end});
  }

  std::string_view text_;
  std::vector<Token> tokens_, comments_;
  std::vector<std::size_t> statements_;
  std::vector<Definition> definitions_;
};

/// The call that encloses a token, and the number of arguments before the token.
struct Enclosing {
  std::string_view name;  ///< name of the function; empty for plain parentheses
  std::size_t token;      ///< its name
  std::size_t argument;   ///< number of arguments that end before
  std::size_t positional;
  std::vector<std::string_view> named;
};

/// Returns the innermost call around token i.
std::optional<Enclosing> enclosing(const Statements& source, std::size_t i) {
  std::vector<Enclosing> calls;
  for (std::size_t k = source.statement_of(i); k < i; ++k) {
    if (source.is(k, "(")) {
      const bool call = k > 0 && source.is_name(k - 1);
      calls.push_back({call ? source.shown(source[k - 1]) : "", k - 1, 0, 0, {}});
    } else if (calls.empty()) {
      continue;
    } else if (source.is(k, ")")) {
      calls.pop_back();
      continue;
    } else if (source.is(k, ",")) {
      Enclosing& call = calls.back();
      ++call.argument;
      call.positional = call.argument - std::min(call.argument, call.named.size());
    } else if (source.is(k, "=") && source.is_name(k - 1) && (source.is(k - 2, "(") || source.is(k - 2, ","))) {
      calls.back().named.push_back(source.shown(source[k - 1]));
    }
  }
  if (calls.empty()) return std::nullopt;
  return calls.back();
}

/// Returns the parameters that may be named in a call.
std::vector<Word> parameters_of(const Statements& source, const Enclosing& call, std::span<const Word> options) {
  std::vector<Word> words;
  const auto add = [&](std::string_view name, const std::string& signature, std::string meaning) {
    words.push_back({std::string(name), WordKind::parameter, signature, std::move(meaning), ""});
  };
  const auto& made = source.definitions();
  const auto defined =
      std::ranges::find_if(made, [&](const Definition& d) { return d.parameters && d.name == call.name; });
  if (defined != made.end() && defined->first < call.token) {
    for (const std::string_view name : *defined->parameters)
      add(name, std::string(name), source.word_of(*defined).meaning);
  } else if (call.name == "open") {
    if (call.argument > 0) words.assign(options.begin(), options.end());
  } else if (call.name == "part") {
    for (const char* const name : {"shape", "name", "colour"}) add(name, name, part_word.signature);
  } else if (const LibraryFunction* const function = find_function(call.name);
             function != nullptr && !function->any_number) {
    for (const Parameter& parameter : function->parameters) {
      const char* const unit = parameter.quantity == Quantity::angle ? "°" : "";
      add(parameter.name,
          parameter.fallback ? fmt::format("{} = {:g}{}", parameter.name, *parameter.fallback, unit)
                             : fmt::format("{}{}", parameter.name, unit),
          signature(*function));
    }
  }
  return words;
}

/// Splits "5 to 40, outer width" into a range and the rest; a comment without a range stays whole.
void read_comment(std::string_view comment, TextParameter& into) {
  comment.remove_prefix(comment.starts_with("//") ? 2 : 1);
  const auto skip = [&] { comment.remove_prefix(std::min(comment.find_first_not_of(" \t\r"), comment.size())); };
  const auto take = [&](double& number) {
    const auto [end, failure] = std::from_chars(comment.data(), comment.data() + comment.size(), number);
    if (failure != std::errc{} || !std::isfinite(number)) return false;
    comment.remove_prefix(static_cast<std::size_t>(end - comment.data()));
    skip();
    return true;
  };
  skip();
  const std::string_view whole = comment;
  TextParameter::Range range{};
  bool found = take(range.low) && comment.starts_with("to ");
  if (found) {
    comment.remove_prefix(3);
    skip();
    found = take(range.high) && range.low < range.high;
  }
  if (found) {
    into.range = range;
    if (comment.starts_with(",")) comment.remove_prefix(1);
    skip();
  } else {
    comment = whole;
  }
  into.comment = printable(comment.substr(0, comment.find_last_not_of(" \t\r") + 1));
}

}  // namespace

std::vector<Token> tokens(std::string_view text) {
  std::vector<Token> all;
  Lexer lexer(text);
  while (const std::optional<Token> token = lexer.next()) all.push_back(*token);
  return all;
}

std::vector<TextParameter> parameters(std::string_view text) {
  const Statements source(text);
  std::unordered_map<std::string_view, int> times;
  for (const Definition& made : source.definitions()) ++times[made.name];
  std::vector<TextParameter> all;
  for (const Definition& made : source.definitions()) {
    const bool minus = source.is(made.body, "-");
    const std::size_t digits = made.body + (minus ? 1 : 0);
    if (made.parameters || digits + 1 != made.end || source[digits].kind != TokenKind::number) continue;
    if (find_constant(made.name) != nullptr || times[made.name] > 1) continue;
    double value = 0;
    const std::string_view shown = source.shown(source[digits]);
    if (std::from_chars(shown.data(), shown.data() + shown.size(), value).ec != std::errc{}) continue;
    if (!std::isfinite(static_cast<float>(value))) continue;
    const Token &name = source[made.first], &last = source[digits];
    const std::size_t start = source[made.body].offset, end = last.offset + last.length;
    TextParameter parameter{std::string(made.name), name.offset, start, end - start, minus ? -value : value, {}, {}};
    const auto comment = std::ranges::lower_bound(source.comments(), end, {}, &Token::offset);
    const bool shared =
        made.end + 1 < source.size() && source.is(made.end, ";") && source[made.end + 1].line == last.line;
    if (comment != source.comments().end() && comment->line == last.line && !shared)
      read_comment(source.shown(*comment), parameter);
    all.push_back(std::move(parameter));
  }
  return all;
}

std::vector<Word> words(std::string_view text) {
  std::vector<Word> all;
  for (const LibraryFunction& function : library()) all.push_back(word_of(function));
  all.insert(all.end(), {open_word, part_word});
  for (const Constant& constant : constants())
    all.push_back({std::string(constant.name), WordKind::constant, std::string(constant.name),
                   std::string(constant.meaning), ""});
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) places.emplace(all[i].name, i);
  const Statements source(text);
  for (const Definition& made : source.definitions()) {
    if (find_constant(made.name) != nullptr) continue;
    const auto [place, is_new] = places.emplace(made.name, all.size());
    if (is_new)
      all.push_back(source.word_of(made));
    else
      all[place->second] = source.word_of(made);
  }
  return all;
}

Completions completions(std::string_view text, std::size_t offset, std::span<const Word> options) {
  offset = std::min(offset, text.size());
  Completions fitting{offset, 0, {}};
  const std::string_view after = text.substr(offset);
  const auto fits = [&](const Word& word, std::string insert) {
    if (begins(word.name, text.substr(fitting.offset, fitting.length)))
      fitting.entries.push_back({word, std::move(insert)});
  };
  const auto holds = [&](const Token& token) { return token.offset < offset && offset <= token.offset + token.length; };
  const Statements source(text);
  if (std::ranges::any_of(source.comments(), holds)) return fitting;

  std::size_t place = source.before(offset);  // the token at the offset
  if (place > 0 && holds(source[place - 1])) {
    const Token& token = source[place - 1];
    const std::string_view shown = source.shown(token);
    if (token.kind == TokenKind::number) return fitting;
    if (token.kind == TokenKind::string && (offset < token.offset + token.length || !is_closed(shown))) {
      fitting.offset = token.offset + 1;
      fitting.length = offset - fitting.offset;
      const auto call = enclosing(source, place - 1);
      const std::string_view named =
          source.is(place - 2, "=") && source.is_name(place - 3) ? source.shown(source[place - 3]) : "";
      const bool colour =
          call && call->name == "part" && (named.empty() ? call->argument == 2 : named == "colour" || named == "color");
      if (colour)
        for (const std::string_view name : colour_names())
          fits({std::string(name), WordKind::colour, std::string(name), text_of(colour_named(name)), ""},
               std::string(name));
      return fitting;
    }
    if (token.kind == TokenKind::name) {
      --place;
      fitting.offset = token.offset;
      fitting.length = offset - token.offset;
      if (place > 0 && source[place - 1].offset + source[place - 1].length == token.offset &&
          source[place - 1].kind == TokenKind::number)
        return fitting;
    }
  }
  const auto call = enclosing(source, place);
  const auto line_of = [&](std::size_t at) {
    return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
  };
  const bool first = place == 0 || source.is(place - 1, ";") ||
                     (!call && static_cast<std::ptrdiff_t>(source[place - 1].line) != line_of(fitting.offset));
  if (!first && (source[place - 1].kind != TokenKind::sign || source.is(place - 1, ")"))) return fitting;

  if (call && (source.is(place - 1, "(") || source.is(place - 1, ","))) {
    const std::vector<Word> parameters = parameters_of(source, *call, options);
    for (std::size_t i = call->name == "open" ? 0 : call->positional; i < parameters.size(); ++i)
      if (std::ranges::find(call->named, parameters[i].name) == call->named.end()) {
        const std::size_t next = after.find_first_not_of(" \t");
        fits(parameters[i], parameters[i].name + (next != std::string_view::npos && after[next] == '=' ? "" : " = "));
      }
    if (call->name == "open") return fitting;
  }
  const auto sorted_from = static_cast<std::ptrdiff_t>(fitting.entries.size());
  const std::size_t statement = first ? place : source.statement_of(place);
  const std::string_view above = text.substr(0, statement < source.size() ? source[statement].offset : text.size());
  for (const Word& word : words(above)) {
    const bool calls = word.signature.ends_with(')') && !after.starts_with('(');
    fits(word, word.name + (calls ? "()" : ""));
  }
  for (const Definition& made : source.definitions())
    if (made.first == statement && made.parameters && made.body <= place)
      for (const std::string_view name : *made.parameters)
        fits({std::string(name), WordKind::variable, std::string(name), source.word_of(made).meaning, ""},
             std::string(name));
  std::ranges::sort(fitting.entries.begin() + sorted_from, fitting.entries.end(), {}, &Word::name);
  return fitting;
}

std::optional<WordAt> word_at(std::string_view text, std::size_t offset, std::span<const Word> options) {
  const Statements source(text);
  if (offset >= text.size() || source.before(offset + 1) == 0) return std::nullopt;
  const std::size_t place = source.before(offset + 1) - 1;
  const Token& token = source[place];
  if (token.kind != TokenKind::name || offset >= token.offset + token.length) return std::nullopt;
  const std::string_view name = source.shown(token);
  const auto found_in = [&](const std::vector<Word>& all) -> std::optional<WordAt> {
    const auto found = std::ranges::find(all, name, &Word::name);
    if (found == all.end()) return std::nullopt;
    return WordAt{*found, token.offset, token.length};
  };
  const std::size_t statement = source.statement_of(place);
  if (source.is(place + 1, "=") && place != statement) {
    const auto call = enclosing(source, place);
    return call ? found_in(parameters_of(source, *call, options)) : std::nullopt;
  }
  for (const Definition& made : source.definitions())
    if (made.first == statement && made.parameters &&
        std::ranges::find(*made.parameters, name) != made.parameters->end())
      return WordAt{{std::string(name), WordKind::variable, std::string(name), source.word_of(made).meaning, ""},
                    token.offset,
                    token.length};
  // Of several definitions, the last one up to this statement.
  std::size_t end = statement;
  while (end < source.size() && source.statement_of(end) == statement) ++end;
  auto found = found_in(words(text.substr(0, end < source.size() ? source[end].offset : text.size())));
  return found ? found : found_in(words(text));
}

}  // namespace fieldfab::frep
