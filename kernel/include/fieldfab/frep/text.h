/// Reading and writing expressions as text: prefix math strings, .vm programs and infix .frep.
///
/// Every parser takes the name that messages should carry, throws Error(bad_input) with "NAME:LINE:COLUMN: what was found and
/// what was expected" in one line, never recurses with the depth of the input, and never reads past the end.
/// For each form parse(print(e)) == e, node for node.
#pragma once

#include <string>
#include <string_view>

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

/// Infix text a person writes; docs/frep-language.md is its manual.
Expression parse_infix(std::string_view text, std::string_view name = "frep text");
std::string print_infix(const Expression& expression);

/// The expression as a graph in Graphviz's language: `dot -Tsvg` draws it. Shared parts are drawn once. Write only.
std::string print_dot(const Expression& expression);

}  // namespace fieldfab::frep
