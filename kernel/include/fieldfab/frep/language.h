/// The .frep language for editors: its tokens, the numbers that a text names, all mistakes, and the names that fit or mean
/// something.
///
/// Everything is found by the lexer and the parser of parse_parts(). Offsets and lengths are bytes of the text, which is UTF-8;
/// lines and columns begin at 1, and columns count bytes. No text makes these functions throw.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/frep/text.h"

namespace fieldfab::frep {

enum class TokenKind {
  comment,  ///< from # or // to the end of its line
  string,   ///< words in quotes, with them; without the closing one where the line ends before it
  number,   ///< without a sign
  name,
  sign,     ///< an operator, a parenthesis, a comma, `=` or `;`
  unknown,  ///< what the language does not have
};

struct Token {
  TokenKind kind;
  std::size_t offset, length;
  std::size_t line, column;
};

/// The tokens of a text, in its order. Between them are blanks, tabs and line ends only; none goes over a line end.
std::vector<Token> tokens(std::string_view text);

/// `width = 20  # 5 to 40, outer width`: a plain number that a statement of the text names. A host may show it as a slider, and
/// replace the `value_length` bytes from `value_offset` on by another number.
struct TextParameter {
  struct Range {
    double low, high;  ///< low < high
  };
  std::string name;
  std::size_t name_offset;
  std::size_t value_offset, value_length;  ///< with its minus sign
  double value;
  std::optional<Range> range;  ///< from a comment on the same line that begins with `LOW to HIGH`
  std::string comment;         ///< the rest of this comment, without its mark
};

/// The parameters of a text, in its order. A name that the text defines twice is none.
std::vector<TextParameter> parameters(std::string_view text);

/// A mistake in a text.
struct Diagnostic {
  std::size_t offset, length;  ///< the token that is wrong; 0 bytes where one is missing
  std::size_t line, column;
  std::string message;  ///< one line, without the place
};

/// The mistakes of a text, a hundred at most: parsing goes on after each with the next statement. The first is the one that
/// parse_parts() throws with the same opener; there is none where it throws none. A name whose definition is wrong has an unknown
/// value, and its uses are no mistakes. Throws only what parse_parts() passes on from the opener: cancelled, internal.
std::vector<Diagnostic> diagnostics(std::string_view text, const Opener& opener = {});

enum class WordKind {
  function,
  constant,
  variable,   ///< a value or function that the text defines
  parameter,  ///< of the function that is called there
  option,     ///< of open()
  colour,
};

/// A name that means something.
struct Word {
  std::string name;
  WordKind kind;
  std::string signature;  ///< "sphere(r = 1)"; the name alone for values
  std::string meaning;    ///< one line; for what the text defines, its line
  std::string example;    ///< .frep text; empty where there is none
};

/// All names that a text can use: the library in its order, constants, and what the text defines.
std::vector<Word> words(std::string_view text);

/// Names that fit at an offset, and the text that they replace: the beginning of a name before the offset.
struct Completions {
  struct Entry : Word {
    std::string insert;  ///< the text to insert: "sphere()", "dx = ", "tomato"
  };
  std::size_t offset, length;
  std::vector<Entry> entries;  ///< parameters of the call in their order, then other names in alphabetic order
};

/// The names that begin as the text does before `offset`, upper and lower case alike: functions, constants, values defined above,
/// parameters by name within a call, `options` within open(), and colours in the third argument of part(). Empty in comments and
/// numbers, and behind a value.
Completions completions(std::string_view text, std::size_t offset, std::span<const Word> options = {});

/// The word at an offset of the text.
struct WordAt : Word {
  std::size_t offset, length;
};
std::optional<WordAt> word_at(std::string_view text, std::size_t offset, std::span<const Word> options = {});

}  // namespace fieldfab::frep
