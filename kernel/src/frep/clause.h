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

/// One operation. In clauses of arity 1, b is not used.
struct Clause {
  Opcode op;
  Operand a, b;
};

}  // namespace fieldfab::frep
