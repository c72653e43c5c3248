// Simplification: by operators when an expression is built, and by simplify() for a whole graph.
#include <cmath>
#include <limits>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {
namespace {

bool is_constant(const Expression& e, double value) { return e.opcode() == Opcode::constant && e.constant() == value; }

/// A folded constant must be finite in single precision, in which it will be used.
bool usable(double value) { return std::isfinite(static_cast<float>(value)); }

Expression simple(Opcode op, const Expression& a) {
  if (a.opcode() == Opcode::constant)
    if (const double value = apply(op, a.constant(), 0.0); usable(value)) return value;
  const Opcode inner = a.opcode();
  if (op == Opcode::negate && inner == Opcode::negate) return a.argument(0);
  if ((op == Opcode::square || op == Opcode::absolute) && (inner == Opcode::negate || inner == Opcode::absolute))
    return simple(op, a.argument(0));
  if (op == Opcode::absolute &&
      (inner == Opcode::square || inner == Opcode::square_root || inner == Opcode::exponential))
    return a;
  return Expression::make(op, a);
}

Expression simple(Opcode op, const Expression& a, const Expression& b) {
  if (a.opcode() == Opcode::constant && b.opcode() == Opcode::constant)
    if (const double value = apply(op, a.constant(), b.constant()); usable(value)) return value;
  switch (op) {
    case Opcode::add:
      if (is_constant(a, 0)) return b;
      if (is_constant(b, 0)) return a;
      if (b.opcode() == Opcode::negate) return simple(Opcode::subtract, a, b.argument(0));
      break;
    case Opcode::subtract:
      if (is_constant(b, 0)) return a;
      if (is_constant(a, 0)) return simple(Opcode::negate, b);
      if (a == b) return 0.0;
      if (b.opcode() == Opcode::negate) return simple(Opcode::add, a, b.argument(0));
      break;
    case Opcode::multiply:
      if (is_constant(a, 1)) return b;
      if (is_constant(b, 1)) return a;
      if (is_constant(a, 0) || is_constant(b, 0)) return 0.0;
      if (is_constant(a, -1)) return simple(Opcode::negate, b);
      if (is_constant(b, -1)) return simple(Opcode::negate, a);
      if (a == b) return simple(Opcode::square, a);
      break;
    case Opcode::divide:
      if (is_constant(b, 1)) return a;
      if (is_constant(b, -1)) return simple(Opcode::negate, a);
      if (is_constant(a, 0)) return 0.0;
      break;
    case Opcode::minimum:
    case Opcode::maximum:
      if (a == b) return a;
      break;
    case Opcode::power:
      if (is_constant(b, 1)) return a;
      if (is_constant(b, 2)) return simple(Opcode::square, a);
      break;
    default: break;
  }
  return Expression::make(op, a, b);
}

}  // namespace

Expression simplify(const Expression& root) {
  const Flat flat = flatten(root);
  std::vector<Expression> made;
  made.reserve(flat.order.size());
  for (const Flat::Entry& entry : flat.order) {
    switch (info(entry.op).arity) {
      case 1: made.push_back(simple(entry.op, made[entry.a])); break;
      case 2: made.push_back(simple(entry.op, made[entry.a], made[entry.b])); break;
      default: made.push_back(made_again(entry, made));
    }
  }
  return made.back();
}

Expression operator+(const Expression& a, const Expression& b) { return simple(Opcode::add, a, b); }
Expression operator-(const Expression& a, const Expression& b) { return simple(Opcode::subtract, a, b); }
Expression operator*(const Expression& a, const Expression& b) { return simple(Opcode::multiply, a, b); }
Expression operator/(const Expression& a, const Expression& b) { return simple(Opcode::divide, a, b); }
Expression operator-(const Expression& a) { return simple(Opcode::negate, a); }
Expression min(const Expression& a, const Expression& b) { return simple(Opcode::minimum, a, b); }
Expression max(const Expression& a, const Expression& b) { return simple(Opcode::maximum, a, b); }
Expression pow(const Expression& a, const Expression& b) { return simple(Opcode::power, a, b); }
Expression atan2(const Expression& y, const Expression& x) { return simple(Opcode::arctangent2, y, x); }
Expression mod(const Expression& a, const Expression& b) { return simple(Opcode::modulo, a, b); }
Expression compare(const Expression& a, const Expression& b) { return simple(Opcode::compare, a, b); }
Expression sin(const Expression& a) { return simple(Opcode::sine, a); }
Expression cos(const Expression& a) { return simple(Opcode::cosine, a); }
Expression tan(const Expression& a) { return simple(Opcode::tangent, a); }
Expression asin(const Expression& a) { return simple(Opcode::arcsine, a); }
Expression acos(const Expression& a) { return simple(Opcode::arccosine, a); }
Expression atan(const Expression& a) { return simple(Opcode::arctangent, a); }
Expression abs(const Expression& a) { return simple(Opcode::absolute, a); }
Expression square(const Expression& a) { return simple(Opcode::square, a); }
Expression sqrt(const Expression& a) { return simple(Opcode::square_root, a); }
Expression exp(const Expression& a) { return simple(Opcode::exponential, a); }
Expression ln(const Expression& a) { return simple(Opcode::logarithm, a); }
Expression floor(const Expression& a) { return simple(Opcode::floor, a); }
Expression ceil(const Expression& a) { return simple(Opcode::ceiling, a); }

}  // namespace fieldfab::frep
