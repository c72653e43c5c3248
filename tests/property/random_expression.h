/// Random expressions for property tests: all operations, constants of all magnitudes, shared
/// subexpressions.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "fieldfab/frep/expression.h"

namespace fieldfab {

/// A uniform integer in [low, high), over the whole range from the first test on (RapidCheck starts
/// with small ones).
inline int draw(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high)); }

}  // namespace fieldfab

namespace fieldfab::frep {

inline double random_constant() {
  const int kind = draw(0, 4);
  const double small = draw(-40, 40) / 8.0;
  if (kind == 0) return std::round(small);
  if (kind == 1) return small;
  if (kind == 2) return small * std::pow(10.0, draw(-6, 6));
  return draw(-100000, 100000) / 7919.0;
}

/// A random expression of about `size` operations. Arguments are drawn from all previous
/// subexpressions, so that many are shared; unused ones are joined at the end.
inline Expression random_expression(int size) {
  std::vector<Expression> parts{Expression::x(), Expression::y(), Expression::z(), random_constant(),
                                random_constant()};
  std::vector<bool> used(parts.size(), true);
  const auto any = [&] {
    const auto i = static_cast<std::size_t>(draw(0, static_cast<int>(parts.size())));
    used[i] = true;
    return parts[i];
  };
  const auto add = [&](Expression part) {
    parts.push_back(std::move(part));
    used.push_back(false);
  };
  for (int i = 0; i < size; ++i) {
    const auto op = static_cast<Opcode>(draw(static_cast<int>(Opcode::sine), opcode_count));
    add(info(op).arity == 1 ? Expression::make(op, any()) : Expression::make(op, any(), any()));
    if (draw(0, 6) == 0) parts.push_back(random_constant()), used.push_back(true);
  }
  constexpr Opcode joints[] = {Opcode::minimum, Opcode::maximum,  Opcode::minimum, Opcode::maximum,
                               Opcode::add,     Opcode::multiply, Opcode::subtract};
  Expression whole = parts.back();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    if (!used[i]) whole = Expression::make(joints[draw(0, 7)], whole, parts[i]);
  return whole;
}

}  // namespace fieldfab::frep
