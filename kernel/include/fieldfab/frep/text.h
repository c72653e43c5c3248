/// Reading and writing expressions as text: prefix math strings, .vm programs and infix .frep.
///
/// Every parser takes the name that messages should carry, throws Error(bad_input) with "NAME:LINE:COLUMN: what was found and
/// what was expected" in one line, never recurses with the depth of the input, and never reads past the end.
/// For each form parse(print(e)) == e, node for node.
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

/// Prefix math string (Keeter Appendix A), as kokopelli reads it: the map operation `m` with three coordinates, each of which
/// may be a blank, and the expression they apply to. The further operations have the letters of opcode.h. White space may end
/// the string; nothing else may follow the expression.
Expression parse_math(std::string_view text, std::string_view name = "math string");
std::string print_math(const Expression& expression);

/// One instruction a line, `NAME OP ARGUMENTS`; the last line is the result; `#` starts a comment (SOURCES.txt of the data).
Expression parse_vm(std::string_view text, std::string_view name = "vm program");
std::string print_vm(const Expression& expression);

/// A named argument of open() in .frep text: `threshold = 300`, `denoise = "median"`.
struct OpenOption {
  std::string name;
  std::variant<double, std::string> value;
};
/// Opens the file that open() names, and returns its solid over x, y and z. Throws as readers of files do, bad_input for an
/// option that means nothing.
using Opener = std::function<Expression(const std::string& path, std::span<const OpenOption> options)>;

/// A solid that a text makes.
struct TextPart {
  Expression shape;
  std::string name;  ///< empty where the text makes one solid and gives it no name
  std::optional<Colour> colour;
  std::string place = {};  ///< of its part(...): NAME:LINE:COLUMN
};

/// Infix text a person writes; docs/frep-language.md is its manual. Gives the parts that the text names with part(...), or its
/// last statement. Values are solids or numbers: `-` is the set difference of two solids, and arithmetic otherwise. Without an
/// opener open() is refused. Throws bad_input as all parsers here do, and what the opener throws, with the place of the call.
std::vector<TextPart> parse_parts(std::string_view text, std::string_view name = "frep text", const Opener& opener = {});
/// The same as one expression: the union of its parts.
Expression parse_infix(std::string_view text, std::string_view name = "frep text", const Opener& opener = {});

/// Infix text; files that were opened are named relative to `folder` where they are in it. Throws bad_input for what was made in
/// memory.
std::string print_infix(const Expression& expression, const std::filesystem::path& folder = {});
/// The text of several parts, or of one that may have no name: parse_parts() reads them back.
std::string print_parts(std::span<const TextPart> parts, const std::filesystem::path& folder = {});

/// Words in quotes, as a text has them: quotes, backslashes and line ends have a backslash before them.
std::string in_quotes(std::string_view words);

/// The expression as a graph in Graphviz's language: `dot -Tsvg` draws it. Shared parts are drawn once. Write only.
std::string print_dot(const Expression& expression);

}  // namespace fieldfab::frep
