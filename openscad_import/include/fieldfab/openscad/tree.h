/// The tree of a .csg file: what is left of an OpenSCAD design once its program has run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fieldfab::openscad {

struct Value;
using List = std::vector<Value>;

/// A value of an argument: undef, a truth value, a number (which may be infinite or NaN), words, or a list of values.
struct Value {
  std::variant<std::monostate, bool, double, std::string, List> held;

  [[nodiscard]] bool is_undef() const { return std::holds_alternative<std::monostate>(held); }
  [[nodiscard]] const double* number() const { return std::get_if<double>(&held); }
  [[nodiscard]] const bool* truth() const { return std::get_if<bool>(&held); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&held); }
  [[nodiscard]] const List* list() const { return std::get_if<List>(&held); }
};

struct Argument {
  std::string name;  ///< empty where none was given
  Value value;
};

/// A node by its number in its tree.
using NodeIndex = std::uint32_t;

/// `name(arguments) { children }`, after the modifiers that stand before it.
struct Node {
  std::string name;
  std::vector<Argument> arguments;
  std::vector<NodeIndex> children;
  std::uint32_t line = 0;   ///< from 1
  bool background = false;  ///< %: shown, not part of the solid
  bool disabled = false;    ///< *: as if it were not there
  bool root = false;        ///< !: the design is this node alone
  bool highlight = false;   ///< #: shown in another colour, too
};

/// All nodes; the first is a group of what stands at the top of the file. Children have greater numbers than their parent.
struct Tree {
  std::string file;  ///< the name that messages carry
  std::vector<Node> nodes;

  [[nodiscard]] const Node& top() const { return nodes.front(); }
  /// "FILE:LINE", for messages about a node.
  [[nodiscard]] std::string place(const Node& node) const { return file + ":" + std::to_string(node.line); }
};

/// Reads the text of a .csg file as OpenSCAD 2021.01 writes it: words in quotes are taken as they are, for it does not mark
/// quotes within them; such a word ends at a quote before a comma or a bracket. Comments are skipped. Of any depth. Throws
/// bad_input with FILE:LINE:COLUMN, what was found and what was expected.
Tree parse_csg(std::string_view text, std::string_view file);

enum class Modifiers { left_out, kept };

/// A node and what is below it as .csg text: what parse_csg() reads back as the same tree. Words that contain quotes or
/// backslashes are written with backslashes before them, as OpenSCAD reads them.
std::string print_csg(const Tree& tree, NodeIndex node, Modifiers modifiers = Modifiers::left_out);

}  // namespace fieldfab::openscad
