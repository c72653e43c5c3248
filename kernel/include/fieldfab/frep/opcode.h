/// The operations of a functional representation, and how each is written in the three text forms.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fieldfab::frep {

/// Keeter's Appendix A, and exp, ln, atan2, mod, floor, ceil and compare.
enum class Opcode : std::uint8_t {
  constant,
  x,
  y,
  z,
  // unary
  sine,
  cosine,
  tangent,
  arcsine,
  arccosine,
  arctangent,
  absolute,
  square,
  square_root,
  negate,
  exponential,
  logarithm,
  floor,
  ceiling,
  // binary
  add,
  subtract,
  multiply,
  divide,
  minimum,
  maximum,
  power,
  arctangent2,
  modulo,
  compare,
  // three coordinates: the value there of a Field that was opened; never part of a tape
  opened,
};
/// Operations that tapes have: all but `opened`.
inline constexpr int opcode_count = static_cast<int>(Opcode::compare) + 1;

/// How an operation is written and how many arguments it takes.
struct OpcodeInfo {
  int arity;               ///< 0, 1 or 2; 3 for `opened`
  char math;               ///< its letter in a prefix math string ('f' for a constant)
  std::string_view vm;     ///< its word in a .vm file
  std::string_view infix;  ///< its function name, or operator sign, in .frep text
};

/// The table's line for `op`.
const OpcodeInfo& info(Opcode op);

/// The value of an operation on numbers in single precision: the definition that every evaluator must reproduce bit for bit.
/// min and max: the first argument where it is not greater (less) than the second, NaN where either is NaN;
/// modulo(a, b): a - b*floor(a/b), so the sign is b's; compare: -1, 0 or 1 (NaN where either is NaN); power: the C library's
/// powf.
float apply(Opcode op, float a, float b = 0);
/// The same in double precision, for constants.
double apply(Opcode op, double a, double b);

}  // namespace fieldfab::frep
