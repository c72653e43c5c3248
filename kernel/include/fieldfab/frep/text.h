/// Parsers and printers of expressions: prefix math strings, .vm programs and infix .frep text.
///
/// Each parser takes the name for messages. It throws Error(bad_input) with "NAME:LINE:COLUMN: what was found and what
/// was expected" on one line. Its recursion depth does not depend on the input, and it never reads past the end. For
/// each form, parse(print(e)) == e, node for node.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Parses a prefix math string (Keeter Appendix A) as kokopelli does. The map operation `m` takes three coordinates,
/// each of which may be a space, and the expression they apply to. opcode.h lists the letters of additional operations.
/// Only white space may follow the expression.
Expression parse_math(std::string_view text, std::string_view name = "math string");
std::string print_math(const Expression& expression);

/// Parses a .vm program: one instruction per line, `NAME OP ARGUMENTS`. The last line is the result; `#` starts a
/// comment (SOURCES.txt of the data).
Expression parse_vm(std::string_view text, std::string_view name = "vm program");
std::string print_vm(const Expression& expression);

/// A named argument of open() in .frep text: `threshold = 300`, `denoise = "median"`.
struct OpenOption {
  std::string name;
  std::variant<double, std::string> value;
};
/// Opens the file named by open() and returns its solid over x, y and z. Throws as readers of files do, and
/// Error(bad_input) for an unknown option.
using Opener = std::function<Expression(const std::string& path, std::span<const OpenOption> options)>;

/// A solid defined by a text.
struct TextPart {
  Expression shape;
  std::string name;  ///< empty if the text defines one solid without a name
  std::optional<Colour> colour;
  std::string place = {};  ///< position of its part(...): NAME:LINE:COLUMN
};

/// Parses infix .frep text (manual: docs/frep-language.md). Returns the parts declared by part(...), or the value of
/// the last statement. Values are solids or numbers: `-` between two solids is the set difference, otherwise
/// arithmetic. Without an opener, open() is an error. Throws Error(bad_input), and errors of the opener with the
/// position of the call.
std::vector<TextPart> parse_parts(std::string_view text, std::string_view name = "frep text",
                                  const Opener& opener = {});
/// Parses infix text and returns the union of its parts.
Expression parse_infix(std::string_view text, std::string_view name = "frep text", const Opener& opener = {});

/// Prints infix text. Names of opened files are relative to `folder` if they are in it. Throws Error(bad_input) for
/// solids made in memory.
std::string print_infix(const Expression& expression, const std::filesystem::path& folder = {});
/// Prints several parts, or one that may be unnamed. parse_parts() reads the text back.
std::string print_parts(std::span<const TextPart> parts, const std::filesystem::path& folder = {});

/// Returns a quoted text for .frep. Quotes, backslashes and line ends are escaped by a backslash.
std::string in_quotes(std::string_view words);

/// Prints the expression as a graph in Graphviz's language, for `dot -Tsvg`. Shared nodes are drawn once. There is no
/// reader.
std::string print_dot(const Expression& expression);

}  // namespace fieldfab::frep
