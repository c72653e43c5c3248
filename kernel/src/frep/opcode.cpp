#include "fieldfab/frep/opcode.h"

#include <array>
#include <cmath>
#include <limits>

#include "functions.h"

namespace fieldfab::frep {
namespace {

constexpr std::array<OpcodeInfo, opcode_count + 1> table{{
    {0, 'f', "const", ""},      {0, 'X', "var-x", "x"},     {0, 'Y', "var-y", "y"}, {0, 'Z', "var-z", "z"},
    {1, 's', "sin", "sin"},     {1, 'c', "cos", "cos"},     {1, 't', "tan", "tan"}, {1, 'S', "asin", "asin"},
    {1, 'C', "acos", "acos"},   {1, 'T', "atan", "atan"},   {1, 'b', "abs", "abs"}, {1, 'q', "square", "square"},
    {1, 'r', "sqrt", "sqrt"},   {1, 'n', "neg", "-"},       {1, 'x', "exp", "exp"}, {1, 'l', "ln", "ln"},
    {1, 'd', "floor", "floor"}, {1, 'u', "ceil", "ceil"},   {2, '+', "add", "+"},   {2, '-', "sub", "-"},
    {2, '*', "mul", "*"},       {2, '/', "div", "/"},       {2, 'i', "min", "min"}, {2, 'a', "max", "max"},
    {2, 'p', "pow", "^"},       {2, 'A', "atan2", "atan2"}, {2, '%', "mod", "mod"}, {2, 'k', "compare", "compare"},
    {3, '\0', "", "open"},
}};

template <class Number>
Number evaluate(Opcode op, Number a, Number b) {
  constexpr Number nan = std::numeric_limits<Number>::quiet_NaN();
  switch (op) {
    case Opcode::constant:
    case Opcode::x:
    case Opcode::y:
    case Opcode::z:
    case Opcode::opened: return a;
    case Opcode::sine: return std::sin(a);
    case Opcode::cosine: return std::cos(a);
    case Opcode::tangent: return std::tan(a);
    case Opcode::arcsine: return std::asin(a);
    case Opcode::arccosine: return std::acos(a);
    case Opcode::arctangent: return std::atan(a);
    case Opcode::absolute: return std::fabs(a);
    case Opcode::square: return a * a;
    case Opcode::square_root: return std::sqrt(a);
    case Opcode::negate: return -a;
    case Opcode::exponential: return std::exp(a);
    case Opcode::logarithm: return std::log(a);
    case Opcode::floor: return std::floor(a);
    case Opcode::ceiling: return std::ceil(a);
    case Opcode::add: return a + b;
    case Opcode::subtract: return a - b;
    case Opcode::multiply: return a * b;
    case Opcode::divide: return a / b;
    case Opcode::minimum: return a != a || b != b ? nan : (a <= b ? a : b);
    case Opcode::maximum: return a != a || b != b ? nan : (a >= b ? a : b);
    case Opcode::power: return std::pow(a, b);
    case Opcode::arctangent2: return std::atan2(a, b);
    case Opcode::modulo: return a - b * std::floor(a / b);
    case Opcode::compare: return a != a || b != b ? nan : static_cast<Number>((a > b) - (a < b));
  }
  return nan;
}

}  // namespace

const OpcodeInfo& info(Opcode op) { return table[static_cast<std::size_t>(op)]; }

float apply(Opcode op, float a, float b) {
  switch (op) {
    case Opcode::sine: return wave_is_near(a) ? function_in_lanes<Opcode::sine, 1>(a, b) : std::sin(a);
    case Opcode::cosine: return wave_is_near(a) ? function_in_lanes<Opcode::cosine, 1>(a, b) : std::cos(a);
    case Opcode::tangent: return wave_is_near(a) ? function_in_lanes<Opcode::tangent, 1>(a, b) : std::tan(a);
    case Opcode::arcsine: return function_in_lanes<Opcode::arcsine, 1>(a, b);
    case Opcode::arccosine: return function_in_lanes<Opcode::arccosine, 1>(a, b);
    case Opcode::arctangent: return function_in_lanes<Opcode::arctangent, 1>(a, b);
    case Opcode::exponential: return function_in_lanes<Opcode::exponential, 1>(a, b);
    case Opcode::logarithm: return function_in_lanes<Opcode::logarithm, 1>(a, b);
    case Opcode::power: return function_in_lanes<Opcode::power, 1>(a, b);
    case Opcode::arctangent2: return function_in_lanes<Opcode::arctangent2, 1>(a, b);
    default: return evaluate(op, a, b);
  }
}
double apply(Opcode op, double a, double b) { return evaluate(op, a, b); }

}  // namespace fieldfab::frep
