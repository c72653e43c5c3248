/// Support of the .frep language for editors: tokens, adjustable parameters, diagnostics, completion and help.
///
/// All results come from the lexer and the parser of parse_parts(). Offsets and lengths are bytes of the UTF-8 text.
/// Lines and columns start at 1; columns count bytes. No text makes these functions throw.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/frep/text.h"

namespace fieldfab::frep {

/// Class of a token.
enum class TokenKind {
  comment,  ///< from # or // to the end of its line
  string,   ///< text including its quotes; the closing quote is absent if the line ends first
  number,   ///< an unsigned number
  name,
  sign,     ///< an operator, a parenthesis, a comma, `=` or `;`
  unknown,  ///< any character that does not belong to the language
};

/// A token: its class, its position and its length.
struct Token {
  TokenKind kind;
  std::size_t offset, length;
  std::size_t line, column;
};

/// Returns the tokens in order. Only spaces, tabs and line ends separate them. No token extends over a line end.
std::vector<Token> tokens(std::string_view text);

/// An adjustable parameter: a plain number that a statement names, as in `width = 20  # 5 to 40, outer width`. A host
/// may show it as a slider and replace the `value_length` bytes from `value_offset` on by another number.
struct TextParameter {
  struct Range {
    double low, high;  ///< limits, low < high
  };
  std::string name;
  std::size_t name_offset;
  std::size_t value_offset, value_length;  ///< includes a minus sign
  double value;
  std::optional<Range> range;  ///< limits from a comment on the same line that starts with `LOW to HIGH`
  std::string comment;         ///< the remaining comment, without # or //
};

/// Returns the parameters in order. Omits names that the text defines twice.
std::vector<TextParameter> parameters(std::string_view text);

/// An error in a text.
struct Diagnostic {
  std::size_t offset, length;  ///< the wrong token; length 0 if a token is missing
  std::size_t line, column;
  std::string message;  ///< one line, without file name and position
};

/// Returns the errors of a text, at most 100. Parsing continues after each error with the next statement. The first
/// error is the one that parse_parts() throws with the same opener; the result is empty if parse_parts() does not
/// throw. A name with a wrong definition has an unknown value, and its uses are not reported. Throws only cancelled and
/// internal errors of the opener.
std::vector<Diagnostic> diagnostics(std::string_view text, const Opener& opener = {});

/// Class of a name.
enum class WordKind {
  function,
  constant,
  variable,   ///< a value or function defined in the text
  parameter,  ///< a parameter of the function called at this place
  option,     ///< an option of open()
  colour,
};

/// A name with its meaning.
struct Word {
  std::string name;
  WordKind kind;
  std::string signature;  ///< call with parameters, such as "sphere(r = 1)"; the name alone for values
  std::string meaning;    ///< one line; for definitions in the text, their line
  std::string example;    ///< example in .frep text; may be empty
};

/// Returns all names available in a text: the library in its order, constants, and definitions in the text.
std::vector<Word> words(std::string_view text);

/// Completions at an offset, and the part of the text that they replace: the prefix of a name before the offset.
struct Completions {
  struct Entry : Word {
    std::string insert;  ///< text to insert, such as "sphere()", "dx = " or "tomato"
  };
  std::size_t offset, length;
  std::vector<Entry> entries;  ///< the parameters of the call in order, then other names in alphabetic order
};

/// Returns the names with the prefix before `offset`, case-insensitive: functions, constants, values defined above,
/// parameters of the surrounding call, `options` within open(), and colours in the third argument of part(). Empty in
/// comments and numbers, and after a value.
Completions completions(std::string_view text, std::size_t offset, std::span<const Word> options = {});

/// The name at an offset of the text.
struct WordAt : Word {
  std::size_t offset, length;
};
/// Returns the name at `offset`, or std::nullopt if there is none.
std::optional<WordAt> word_at(std::string_view text, std::size_t offset, std::span<const Word> options = {});

}  // namespace fieldfab::frep
