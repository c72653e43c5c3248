// Reference implementation: one point after the other, by the reference evaluator's functions.
// evaluate_ranges() handles boxes.
#include <array>

#include "batch.h"
#include "derivative.h"

namespace fieldfab::frep {
namespace {

/// Value of an operand at point i: of a clause, a coordinate or a constant.
float value_of(const BatchRun& run, Operand operand, std::size_t i, std::size_t numbers_a_slot) {
  if (is_constant(operand)) return run.constants[operand & ~constant_bit];
  if (is_made(operand)) return run.scratch[run.code[operand - first_value].slot * numbers_a_slot];
  return std::array{run.x, run.y, run.z}[operand][i];
}

float slope_of(const BatchRun& run, Operand operand, std::size_t axis) {
  if (is_constant(operand)) return 0;
  if (is_made(operand)) return run.scratch[run.code[operand - first_value].slot * 4 + 1 + axis];
  return operand == axis ? 1.0F : 0.0F;
}

void run_values(const BatchRun& run, float* out) {
  for (std::size_t i = 0; i < run.count; ++i) {
    for (std::size_t c = 0; c < run.clauses; ++c) {
      const Clause& clause = run.code[c];
      run.scratch[clause.slot] = apply(clause.op, value_of(run, clause.a, i, 1), value_of(run, clause.b, i, 1));
    }
    out[i] = value_of(run, run.root, i, 1);
  }
}

void run_gradients(const BatchRun& run, float* out, float* dx, float* dy, float* dz) {
  for (std::size_t i = 0; i < run.count; ++i) {
    for (std::size_t c = 0; c < run.clauses; ++c) {
      const Clause& clause = run.code[c];
      const float a = value_of(run, clause.a, i, 4), b = value_of(run, clause.b, i, 4), value = apply(clause.op, a, b);
      const Partials d = partials(clause.op, a, b, value);
      const bool two = arity(clause.op) == 2;
      std::array<float, 3> slope;
      for (std::size_t axis = 0; axis < 3; ++axis)
        slope[axis] = chain(d.a, slope_of(run, clause.a, axis), two ? d.b : 0, slope_of(run, clause.b, axis));
      run.scratch[clause.slot * 4] = value;
      for (std::size_t axis = 0; axis < 3; ++axis) run.scratch[clause.slot * 4 + 1 + axis] = slope[axis];
    }
    out[i] = value_of(run, run.root, i, 4);
    dx[i] = slope_of(run, run.root, 0), dy[i] = slope_of(run, run.root, 1), dz[i] = slope_of(run, run.root, 2);
  }
}

std::uint32_t run_intervals(const IntervalRun& /*run*/, LaneRanges& /*root*/) { return ~0U; }

}  // namespace

constinit const Runners reference_runners{run_values, run_gradients, run_intervals, nullptr, nullptr, nullptr};

}  // namespace fieldfab::frep
