// Partial derivatives of each operation. The reference evaluator and the batch evaluators of all
// instruction sets share this text, so that their results have the same bits. Internal linkage on
// purpose: each instruction set compiles its own copy.
#pragma once

#include "fieldfab/frep/opcode.h"

namespace fieldfab::frep {
namespace {

struct Partials {
  float a, b;
};

/// d op / d a and d op / d b, for `value` = op(a, b). One-sided at creases; 0 if there is no slope
/// (abs, sqrt at 0).
inline Partials partials(Opcode op, float a, float b, float value) {
  switch (op) {
    case Opcode::sine: return {apply(Opcode::cosine, a), 0};
    case Opcode::cosine: return {-apply(Opcode::sine, a), 0};
    case Opcode::tangent: return {1 + value * value, 0};
    case Opcode::arcsine: return {1 / __builtin_sqrtf(1 - a * a), 0};
    case Opcode::arccosine: return {-1 / __builtin_sqrtf(1 - a * a), 0};
    case Opcode::arctangent: return {1 / (1 + a * a), 0};
    case Opcode::absolute: return {a > 0 ? 1.0F : a < 0 ? -1.0F : 0.0F, 0};
    case Opcode::square: return {2 * a, 0};
    case Opcode::square_root: return {value > 0 ? 0.5F / value : 0.0F, 0};
    case Opcode::negate: return {-1, 0};
    case Opcode::exponential: return {value, 0};
    case Opcode::logarithm: return {1 / a, 0};
    case Opcode::floor:
    case Opcode::ceiling:
    case Opcode::compare: return {0, 0};
    case Opcode::add: return {1, 1};
    case Opcode::subtract: return {1, -1};
    case Opcode::multiply: return {b, a};
    case Opcode::divide: return {1 / b, -value / b};
    case Opcode::minimum: return a <= b ? Partials{1, 0} : Partials{0, 1};
    case Opcode::maximum: return a >= b ? Partials{1, 0} : Partials{0, 1};
    case Opcode::power:
      return {b == 0 ? 0.0F : b * apply(Opcode::power, a, b - 1), a > 0 ? value * apply(Opcode::logarithm, a) : 0.0F};
    case Opcode::arctangent2: {
      const float square = a * a + b * b;
      return {b / square, -a / square};
    }
    case Opcode::modulo: return {1, -__builtin_floorf(a / b)};
    default: return {0, 0};
  }
}

/// Chain rule for one coordinate. An argument that does not matter or does not change is left out,
/// so that 0 * infinity does not produce NaN.
inline float chain(float da, float ga, float db, float gb) {
  const float left = da == 0 || ga == 0 ? 0.0F : da * ga, right = db == 0 || gb == 0 ? 0.0F : db * gb;
  return left + right;
}

}  // namespace
}  // namespace fieldfab::frep
