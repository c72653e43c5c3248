/// The reference evaluators, which define the meaning of an expression. They evaluate one node after the other. Each
/// faster evaluator agrees with them bit for bit (tests/property).
#pragma once

#include <array>

#include "fieldfab/core/interval.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Returns the value at a point; each operation is apply() of opcode.h in single precision. Linear in the number of
/// nodes.
float evaluate(const Expression& expression, float x, float y, float z);

/// Value and gradient at a point, by forward differentiation in single precision. At a crease the gradient is that of
/// the argument that gives the value, and of the first on a tie. The slopes of abs(0) and sqrt(0) are 0.
struct ValueAndGradient {
  float value;
  std::array<float, 3> gradient;
};
ValueAndGradient evaluate_gradient(const Expression& expression, float x, float y, float z);

/// Returns an interval that contains each result of evaluate() for coordinates in the given intervals (interval.h
/// proves it).
Interval evaluate_interval(const Expression& expression, Interval x, Interval y, Interval z);

/// Applies one operation to intervals.
Interval apply(Opcode op, Interval a, Interval b = Interval::of(0));

}  // namespace fieldfab::frep
