/// Running a tape over a batch of points, or of boxes. One implementation, compiled for several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "clause.h"

namespace fieldfab::frep {

/// A tape and the memory to run it in, as plain pointers: the files compiled for AVX must not instantiate anything that the
/// linker could share with code meant for other processors.
struct BatchRun {
  const Clause* code;
  std::size_t clauses;
  const float* constants;
  Operand root;
  const float* x;
  const float* y;
  const float* z;
  std::size_t count;   ///< points, at most `stride`
  float* scratch;      ///< slots * stride floats; for gradients 4 * slots * stride
  std::size_t stride;  ///< floats between slots
};

/// Boxes whose intervals are evaluated together: each is a lane.
inline constexpr std::size_t box_lanes = 16;

/// An interval in each lane.
struct LaneRanges {
  float lower[box_lanes];
  float upper[box_lanes];
};

/// In which lanes a min or max is known to be its first argument or its second; an absolute value its argument or its negative.
/// Where both are set, the first is meant.
struct Choice {
  std::uint16_t first, second;
};

struct IntervalRun {
  const Clause* code;
  std::size_t clauses;
  const float* constants;
  Operand root;
  LaneRanges box[3];    ///< x, y and z; every lane has some box
  std::size_t lanes;    ///< how many lanes are asked for
  bool occupancy;       ///< where only a sign matters, choose by sign (Boolean pruning)
  LaneRanges* scratch;  ///< one for each slot
  Choice* choices;      ///< one for each clause
};

/// apply() for intervals of numbers; false where the result is not finite or may be NaN.
bool finite_interval(Opcode op, float a_lower, float a_upper, float b_lower, float b_upper, float* out);

using RunValues = void (*)(const BatchRun&, float* out);
using RunGradients = void (*)(const BatchRun&, float* out, float* dx, float* dy, float* dz);
/// Writes the root's intervals. Returns the lanes, a bit each, in which something was not a finite number: their intervals and
/// choices mean nothing, and are to be had from evaluate_ranges().
using RunIntervals = std::uint32_t (*)(const IntervalRun&, LaneRanges& root);

/// One operation on n points: `in` holds n first and n second arguments. For partials, n values follow them, and `out` gets n
/// derivatives by the first and n by the second. For intervals, `in` holds n lower and n upper ends of the first and of the
/// second arguments, and `out` gets n lower and n upper ends and n marks, all of whose bits are set where something is not
/// finite.
using RunOperation = void (*)(Opcode op, const float* in, float* out, std::size_t n);

/// The evaluators for one instruction set.
struct Runners {
  RunValues values;
  RunGradients gradients;
  RunIntervals intervals;
  RunOperation operation, partials, interval;
};
extern const Runners reference_runners, portable_runners, avx2_runners, avx512_runners;

}  // namespace fieldfab::frep
