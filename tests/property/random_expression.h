/// Random expressions for property tests: every operation, constants of all sizes, shared parts.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

inline double random_constant() {
  const int kind = *rc::gen::inRange(0, 4);
  const double small = *rc::gen::inRange(-40, 40) / 8.0;
  if (kind == 0) return std::round(small);
  if (kind == 1) return small;
  if (kind == 2) return small * std::pow(10.0, *rc::gen::inRange(-6, 6));
  return *rc::gen::inRange(-100000, 100000) / 7919.0;
}

/// An expression of about `size` operations; arguments are drawn from all parts made so far, so that many are shared.
inline Expression random_expression(int size) {
  std::vector<Expression> parts{Expression::x(), Expression::y(), Expression::z(), random_constant(), random_constant()};
  const auto any = [&] {
    // The newest parts are likeliest, so that expressions grow deep as well as wide.
    const auto count = static_cast<int>(parts.size());
    const int back = std::min(*rc::gen::inRange(0, count), *rc::gen::inRange(0, count));
    return parts[static_cast<std::size_t>(count - 1 - back)];
  };
  for (int i = 0; i < size; ++i) {
    const auto op = static_cast<Opcode>(*rc::gen::inRange(static_cast<int>(Opcode::sine), opcode_count));
    parts.push_back(info(op).arity == 1 ? Expression::make(op, any()) : Expression::make(op, any(), any()));
    if (*rc::gen::inRange(0, 6) == 0) parts.push_back(random_constant());
  }
  return parts.back();
}

}  // namespace fieldfab::frep
