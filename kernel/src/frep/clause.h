/// One operation of a tape. Includes next to nothing: it is compiled for every instruction set.
#pragma once

#include <cstdint>

#include "fieldfab/frep/opcode.h"

namespace fieldfab::frep {

/// Where an argument comes from: a constant (top bit set, index into Tape::constants), else the value of that number. Values 0, 1
/// and 2 are x, y and z; value 3 + i is what clause i makes.
using Operand = std::uint32_t;
inline constexpr Operand constant_bit = 1U << 31;
inline constexpr Operand first_value = 3;

/// One operation. In clauses of arity 1, b is a.
struct Clause {
  Opcode op;
  /// Whether the root's sign depends on this clause's sign only: all that lies between are min, max and negation.
  bool only_sign_matters;
  /// Where its value is kept while a batch is evaluated: slots are reused, so that a batch stays in the cache.
  std::uint32_t slot;
  Operand a, b;
};

constexpr int arity(Opcode op) { return op >= Opcode::add ? 2 : op >= Opcode::sine ? 1 : 0; }
constexpr bool is_constant(Operand operand) { return (operand & constant_bit) != 0; }
/// Whether a clause makes it: neither a constant nor x, y or z.
constexpr bool is_made(Operand operand) { return operand - first_value < constant_bit - first_value; }

}  // namespace fieldfab::frep
