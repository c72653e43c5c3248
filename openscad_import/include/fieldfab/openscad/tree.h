/// The syntax tree of a .csg file: an OpenSCAD design after evaluation of its program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fieldfab::openscad {

struct Value;
using List = std::vector<Value>;

/// An argument's value: undef, a Boolean, a number (which may be infinite or NaN), a string, or a list of values.
struct Value {
  std::variant<std::monostate, bool, double, std::string, List> held;

  [[nodiscard]] bool is_undef() const { return std::holds_alternative<std::monostate>(held); }
  [[nodiscard]] const double* number() const { return std::get_if<double>(&held); }
  [[nodiscard]] const bool* truth() const { return std::get_if<bool>(&held); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&held); }
  [[nodiscard]] const List* list() const { return std::get_if<List>(&held); }
};

/// An argument of a node.
struct Argument {
  std::string name;  ///< empty for a positional argument
  Value value;
};

/// Index of a node in its tree.
using NodeIndex = std::uint32_t;

/// A node: `name(arguments) { children }`, with the modifiers before it.
struct Node {
  std::string name;
  std::vector<Argument> arguments;
  std::vector<NodeIndex> children;
  std::uint32_t line = 0;   ///< from 1
  bool background = false;  ///< %: displayed, not part of the solid
  bool disabled = false;    ///< *: ignored
  bool root = false;        ///< !: the design consists of this node only
  bool highlight = false;   ///< #: shown in another colour, too
};

/// A tree. The first node is a group of all top-level nodes. Children have greater indices than their parent.
struct Tree {
  std::string file;  ///< name for messages
  std::vector<Node> nodes;

  [[nodiscard]] const Node& top() const { return nodes.front(); }
  /// Returns "FILE:LINE" of a node, for messages.
  [[nodiscard]] std::string place(const Node& node) const { return file + ":" + std::to_string(node.line); }
};

/// Parses a .csg file as written by OpenSCAD 2021.01. Strings are taken verbatim, because OpenSCAD does not escape
/// quotes within them: a string ends at a quote before a comma or a bracket. Comments are skipped. Nesting depth is not
/// limited. Throws Error(bad_input) with FILE:LINE:COLUMN, what was found and what was expected.
Tree parse_csg(std::string_view text, std::string_view file);

/// Whether the modifiers % * ! # are printed.
enum class Modifiers { left_out, kept };

/// Prints a node and its descendants as .csg text, which parse_csg() reads back as the same tree. Quotes and
/// backslashes in strings are escaped by backslashes, as OpenSCAD reads them.
std::string print_csg(const Tree& tree, NodeIndex node, Modifiers modifiers = Modifiers::left_out);

}  // namespace fieldfab::openscad
