// Numbers, parameters and [expressions] of G-code, evaluated during parsing.
#pragma once

#include <string>
#include <string_view>

#include "parameters.h"

namespace fieldfab::cam::gcode {

/// Position of the parser in a line without spaces and in lower case.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  [[nodiscard]] bool done() const { return at >= text.size(); }
  [[nodiscard]] char peek() const { return done() ? '\0' : text[at]; }
  /// Consumes `expected` if it is next.
  bool take(char expected) {
    if (peek() != expected) return false;
    ++at;
    return true;
  }
  bool take(std::string_view expected) {
    if (!text.substr(at).starts_with(expected)) return false;
    at += expected.size();
    return true;
  }
};

/// Reads one value: a number, #parameter, [expression], function, or one of these with a sign.
/// Throws Refusal for anything else, and for values that are not finite. Operators of equal rank
/// associate to the left. Ranks: **, then * / mod, + -, comparisons, and or xor.
double read_value(Cursor& cursor, const Parameters& parameters, int depth = 0);

/// An integer value (within 0.0001).
int read_whole(Cursor& cursor, const Parameters& parameters);

/// The name after '#<', up to '>', which is consumed, too. A name may contain brackets (_hal[...],
/// _ini[...]).
std::string_view read_name(Cursor& cursor);

/// A value as an integer. Throws Refusal for a value more than 0.0001 from an integer, or beyond
/// `limit`.
int whole(double value, int limit = 1'000'000'000);

}  // namespace fieldfab::cam::gcode
