// Numbers, parameters and [expressions] of G-code, evaluated as they are read.
#pragma once

#include <string>
#include <string_view>

#include "parameters.h"

namespace fieldfab::cam::gcode {

/// Where reading stands in a line without spaces and in lower case.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  [[nodiscard]] bool done() const { return at >= text.size(); }
  [[nodiscard]] char peek() const { return done() ? '\0' : text[at]; }
  /// Takes `expected` where it comes next.
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

/// Reads one value: a number, #parameter, [expression], function, or one of these behind a sign. Refuses all else, and whatever
/// is not finite. Operators of one rank go from left to right: ** binds most, then * / mod, + -, comparisons, and or xor.
double read_value(Cursor& cursor, const Parameters& parameters, int depth = 0);

/// A value that must be whole (within 0.0001).
int read_whole(Cursor& cursor, const Parameters& parameters);

/// The name behind '#<': up to '>', which is taken, too. A name may have brackets in it (_hal[...], _ini[...]).
std::string_view read_name(Cursor& cursor);

/// A value as a whole number; refuses what is farther than 0.0001 from one, or beyond `limit`.
int whole(double value, int limit = 1'000'000'000);

}  // namespace fieldfab::cam::gcode
