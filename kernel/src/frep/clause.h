/// One operation of a tape. Includes almost no headers, since it is compiled for each instruction
/// set.
#pragma once

#include <cstdint>

#include "fieldfab/frep/opcode.h"

namespace fieldfab::frep {

/// Source of an argument: a constant (top bit set, index into Tape::constants), or a value by its
/// number. Values 0, 1 and 2 are x, y and z; value 3 + i is the result of clause i.
using Operand = std::uint32_t;
inline constexpr Operand constant_bit = 1U << 31;
inline constexpr Operand first_value = 3;

/// One operation. In clauses of arity 1, b equals a.
struct Clause {
  Opcode op;
  /// Whether the sign of the root depends only on the sign of this clause: all clauses in between
  /// are min, max and negation.
  bool only_sign_matters;
  /// Memory for its value during evaluation of a batch. Slots are reused, so that a batch stays in
  /// the cache.
  std::uint32_t slot;
  Operand a, b;
};

constexpr int arity(Opcode op) { return op >= Opcode::add ? 2 : op >= Opcode::sine ? 1 : 0; }
constexpr bool is_constant(Operand operand) { return (operand & constant_bit) != 0; }
/// Whether the operand is the result of a clause: neither a constant nor x, y or z.
constexpr bool is_made(Operand operand) { return operand - first_value < constant_bit - first_value; }

}  // namespace fieldfab::frep
