/// The operations of a functional representation, and their notation in the three text forms.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fieldfab::frep {

/// Operations: those of Keeter's Appendix A, and exp, ln, atan2, mod, floor, ceil and compare.
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
  // the value of an opened Field at three coordinates; never part of a tape
  opened,
};
/// Number of operations in tapes: all except `opened`.
inline constexpr int opcode_count = static_cast<int>(Opcode::compare) + 1;

/// Notation and arity of an operation.
struct OpcodeInfo {
  int arity;               ///< 0, 1 or 2; 3 for `opened`
  char math;               ///< letter in a prefix math string ('f' for a constant)
  std::string_view vm;     ///< word in a .vm file
  std::string_view infix;  ///< function name or operator in .frep text
};

/// Returns the table entry of `op`.
const OpcodeInfo& info(Opcode op);

/// Evaluates an operation in single precision. This is the definition that each evaluator reproduces bit for bit.
/// - min and max return the first argument on a tie, and NaN if either argument is NaN.
/// - modulo(a, b) is a - b*floor(a/b), so that the sign is that of b.
/// - compare returns -1, 0 or 1, and NaN if either argument is NaN.
/// - Transcendental functions return the nearest float or, rarely, its neighbour, and C's special values.
float apply(Opcode op, float a, float b = 0);
/// Evaluates an operation in double precision, for constant folding.
double apply(Opcode op, double a, double b);

}  // namespace fieldfab::frep
