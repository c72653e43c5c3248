/// The reference evaluators: the definition of what an expression means. Plain, slow, one node after the other.
/// Every faster evaluator must agree with these bit for bit (tests/property).
#pragma once

#include <array>

#include "fieldfab/core/interval.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// The value at a point; every operation is apply() of opcode.h in single precision.
float evaluate(const Expression& expression, float x, float y, float z);

/// Value and gradient at a point, by forward differentiation in single precision.
/// Creases take one side: the argument that gives the value, the first on a tie; abs(0) has slope 0 as sqrt(0) has slope 0.
struct ValueAndGradient {
  float value;
  std::array<float, 3> gradient;
};
ValueAndGradient evaluate_gradient(const Expression& expression, float x, float y, float z);

/// An interval that holds every evaluate() for coordinates from the given intervals (interval.h states why it is sound).
Interval evaluate_interval(const Expression& expression, Interval x, Interval y, Interval z);

/// One operation on intervals.
Interval apply(Opcode op, Interval a, Interval b = Interval::of(0));

}  // namespace fieldfab::frep
