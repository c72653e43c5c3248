#include "fieldfab/frep/reference.h"

#include "derivative.h"

namespace fieldfab::frep {
namespace {

/// Calls visit(entry, index) for each node after its arguments.
template <class Visit>
void for_each_node(const Flat& flat, const Visit& visit) {
  for (std::size_t i = 0; i < flat.order.size(); ++i) visit(flat.order[i], i);
}

template <class Number>
Number leaf(const Flat::Entry& entry, Number constant, Number x, Number y, Number z) {
  switch (entry.op) {
    case Opcode::x: return x;
    case Opcode::y: return y;
    case Opcode::z: return z;
    default: return constant;
  }
}

}  // namespace

float evaluate(const Expression& expression, float x, float y, float z) {
  const Flat flat = flatten(expression);
  std::vector<float> value(flat.order.size());
  for_each_node(flat, [&](const Flat::Entry& entry, std::size_t i) {
    if (entry.op == Opcode::opened)
      value[i] = entry.source->field->value({value[entry.a], value[entry.b], value[entry.c]});
    else
      value[i] = info(entry.op).arity == 0 ? leaf(entry, static_cast<float>(entry.constant), x, y, z)
                                           : apply(entry.op, value[entry.a], value[entry.b]);
  });
  return value.back();
}

ValueAndGradient evaluate_gradient(const Expression& expression, float x, float y, float z) {
  const Flat flat = flatten(expression);
  std::vector<ValueAndGradient> result(flat.order.size());
  for_each_node(flat, [&](const Flat::Entry& entry, std::size_t i) {
    if (info(entry.op).arity == 0) {
      result[i] = leaf<ValueAndGradient>(entry, {static_cast<float>(entry.constant), {0, 0, 0}}, {x, {1, 0, 0}},
                                         {y, {0, 1, 0}}, {z, {0, 0, 1}});
      return;
    }
    const ValueAndGradient& a = result[entry.a];
    const ValueAndGradient& b = result[entry.b];
    result[i].value = apply(entry.op, a.value, b.value);
    const Partials d = partials(entry.op, a.value, b.value, result[i].value);
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[i].gradient[axis] = chain(d.a, a.gradient[axis], d.b, b.gradient[axis]);
  });
  return result.back();
}

Interval evaluate_interval(const Expression& expression, Interval x, Interval y, Interval z) {
  const Flat flat = flatten(expression);
  std::vector<Interval> range(flat.order.size());
  for_each_node(flat, [&](const Flat::Entry& entry, std::size_t i) {
    range[i] = info(entry.op).arity == 0 ? leaf(entry, Interval::of(static_cast<float>(entry.constant)), x, y, z)
                                         : apply(entry.op, range[entry.a], range[entry.b]);
  });
  return range.back();
}

}  // namespace fieldfab::frep
