// Parser of .csg files. Nodes are kept on an explicit stack, so that nesting depth is limited by
// memory, not by the call stack.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"
#include "fieldfab/openscad/tree.h"

namespace fieldfab::openscad {
namespace {

constexpr std::size_t most_nodes = 4'000'000;
constexpr int deepest_list = 64;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
 public:
  Parser(std::string_view text, std::string_view file) : text_(text) { tree_.file = std::string(file); }

  Tree run() {
    Node top;
    top.name = "group";
    top.line = 1;
    tree_.nodes.push_back(std::move(top));
    open_.push_back(0);
    for (skip(); at_ < text_.size(); skip()) {
      if (text_[at_] == '}') {
        if (open_.size() == 1) fail("there is a '}' without its '{'");
        ++at_;
        open_.pop_back();
      } else if (text_[at_] == ';') {
        ++at_;
      } else {
        node();
      }
    }
    if (open_.size() > 1)
      throw Error(ErrorKind::bad_input, tree_.place(tree_.nodes[open_.back()]),
                  fmt::format("the text ends before the '}}' of this {}", tree_.nodes[open_.back()].name));
    return std::move(tree_);
  }

 private:
  void node() {
    Node node;
    for (;; skip()) {
      const char c = peek();
      if (c == '%')
        node.background = true;
      else if (c == '*')
        node.disabled = true;
      else if (c == '!')
        node.root = true;
      else if (c == '#')
        node.highlight = true;
      else
        break;
      ++at_;
    }
    node.line = line();
    if (!is_letter(peek())) fail(fmt::format("expected the name of a node, found {}", shown()));
    node.name = std::string(name());
    skip();
    expect('(');
    arguments(node);
    skip();
    if (tree_.nodes.size() >= most_nodes)
      throw Error(ErrorKind::too_large, tree_.file, fmt::format("has more than {} nodes", most_nodes));
    const auto index = static_cast<NodeIndex>(tree_.nodes.size());
    tree_.nodes[open_.back()].children.push_back(index);
    tree_.nodes.push_back(std::move(node));
    if (peek() == '{') {
      ++at_;
      open_.push_back(index);
    } else {
      expect(';');
    }
  }

  void arguments(Node& node) {
    for (skip(); peek() != ')'; skip()) {
      Argument argument;
      if (is_letter(peek())) {
        const std::size_t start = at_;
        argument.name = std::string(name());
        skip();
        if (peek() == '=') {
          ++at_;
          skip();
        } else {  // a word such as true
          at_ = start;
          argument.name.clear();
        }
      }
      argument.value = value(0);
      node.arguments.push_back(std::move(argument));
      skip();
      if (peek() == ',')
        ++at_;
      else if (peek() != ')')
        fail(fmt::format("expected ',' or ')' after an argument of {}, found {}", node.name, shown()));
    }
    ++at_;
  }

  Value value(int depth) {
    const char c = peek();
    if (c == '[') return list(depth);
    if (c == '"') return {words()};
    if (is_letter(c)) {
      const std::size_t start = at_;
      const std::string_view word = name();
      if (word == "true") return {true};
      if (word == "false") return {false};
      if (word == "undef") return {};
      if (word == "inf") return {std::numeric_limits<double>::infinity()};
      if (word == "nan") return {std::numeric_limits<double>::quiet_NaN()};
      at_ = start;
      fail(fmt::format("expected a value, found '{:.40}'", word));
    }
    return {number()};
  }

  Value list(int depth) {
    if (depth >= deepest_list) fail(fmt::format("lists within more than {} lists are not read", deepest_list));
    ++at_;
    List list;
    for (skip(); peek() != ']'; skip()) {
      list.push_back(value(depth + 1));
      skip();
      if (peek() == ',')
        ++at_;
      else if (peek() != ']')
        fail(fmt::format("expected ',' or ']' in a list, found {}", shown()));
    }
    ++at_;
    return {std::move(list)};
  }

  /// OpenSCAD does not escape quotes within strings, so a quote ends a string only where a value
  /// may end.
  std::string words() {
    std::string found;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size() && (text_[at_ + 1] == '"' || text_[at_ + 1] == '\\')) {
        found += text_[++at_];
        continue;
      }
      if (text_[at_] == '"') {
        const std::size_t next = text_.find_first_not_of(" \t\r\n", at_ + 1);
        if (next == std::string_view::npos || text_[next] == ',' || text_[next] == ')' || text_[next] == ']') {
          ++at_;
          return found;
        }
      }
      found += text_[at_];
    }
    fail("the text ends within words in quotes");
  }

  double number() {
    std::size_t start = at_;
    if (peek() == '+') ++start;
    const bool minus = start < text_.size() && text_[start] == '-';
    if (text_.substr(start + (minus ? 1 : 0), 3) == "inf") {
      at_ = start + (minus ? 4 : 3);
      return (minus ? -1 : 1) * std::numeric_limits<double>::infinity();
    }
    if (text_.substr(start, 4) == "-nan") {
      at_ = start + 4;
      return std::numeric_limits<double>::quiet_NaN();
    }
    double value = 0;
    const auto [end, failure] = std::from_chars(text_.data() + start, text_.data() + text_.size(), value);
    if (failure == std::errc::invalid_argument) fail(fmt::format("expected a value, found {}", shown()));
    at_ = static_cast<std::size_t>(end - text_.data());
    return failure == std::errc{} ? value : 0;  // below the range of doubles, or too large to be meaningful
  }

  std::string_view name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return text_.substr(start, at_ - start);
  }

  void skip() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) fail("the text ends within a comment");
        at_ = end + 2;
      } else {
        return;
      }
    }
  }

  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void expect(char c) {
    if (peek() != c || at_ >= text_.size()) fail(fmt::format("expected '{}', found {}", c, shown()));
    ++at_;
  }
  [[nodiscard]] std::string shown() const {
    if (at_ >= text_.size()) return "the end of the text";
    const char c = text_[at_];
    if (c >= 33 && c < 127) return fmt::format("'{}'", c);
    return fmt::format("byte 0x{:02x}", static_cast<unsigned char>(c));
  }
  /// Lines are counted incrementally, not from the start for each node.
  std::uint32_t line() {
    for (; counted_ < at_; ++counted_)
      if (text_[counted_] == '\n') ++line_;
    return line_;
  }
  [[noreturn]] void fail(const std::string& message) {
    const std::size_t end = std::min(at_, text_.size());
    const std::size_t before = end == 0 ? std::string_view::npos : text_.rfind('\n', end - 1);
    const std::size_t column = before == std::string_view::npos ? end + 1 : end - before;
    const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n') + 1;
    throw Error(ErrorKind::bad_input, fmt::format("{}:{}:{}", tree_.file, lines, column), message);
  }

  std::string_view text_;
  std::size_t at_ = 0, counted_ = 0;
  std::uint32_t line_ = 1;
  Tree tree_;
  std::vector<NodeIndex> open_;
};

void print(const Value& value, std::string& out) {
  if (value.is_undef()) {
    out += "undef";
  } else if (const bool* truth = value.truth()) {
    out += *truth ? "true" : "false";
  } else if (const double* number = value.number()) {
    out += std::isnan(*number) ? "nan" : fmt::format("{}", *number);
  } else if (const std::string* text = value.text()) {
    out += '"';
    for (const char c : *text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    out += '"';
  } else {
    const char* between = "[";
    for (const Value& item : *value.list()) {
      out += between;
      print(item, out);
      between = ", ";
    }
    out += value.list()->empty() ? "[]" : "]";
  }
}

}  // namespace

Tree parse_csg(std::string_view text, std::string_view file) { return Parser(text, file).run(); }

std::string print_csg(const Tree& tree, NodeIndex node, Modifiers modifiers) {
  std::string out;
  struct Open {
    NodeIndex node;
    std::size_t next;
  };
  const auto head = [&](const Node& here) {
    if (modifiers == Modifiers::kept)
      for (const auto& [is_set, sign] :
           {std::pair{here.background, '%'}, {here.disabled, '*'}, {here.root, '!'}, {here.highlight, '#'}})
        if (is_set) out += sign;
    out += here.name + "(";
    const char* between = "";
    for (const Argument& argument : here.arguments) {
      out += between;
      if (!argument.name.empty()) out += argument.name + " = ";
      print(argument.value, out);
      between = ", ";
    }
    out += here.children.empty() ? ");\n" : ") {\n";
  };
  std::vector<Open> open{{node, 0}};
  head(tree.nodes[node]);
  while (!open.empty()) {
    const Node& here = tree.nodes[open.back().node];
    if (open.back().next == here.children.size()) {
      if (!here.children.empty()) out += "}\n";
      open.pop_back();
      continue;
    }
    const NodeIndex child = here.children[open.back().next++];
    head(tree.nodes[child]);
    open.push_back({child, 0});
  }
  return out;
}

}  // namespace fieldfab::openscad
