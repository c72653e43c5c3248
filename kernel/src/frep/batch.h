/// Evaluation of a tape over a batch of points, or of boxes. One implementation, compiled for
/// several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "clause.h"

namespace fieldfab::frep {

/// A tape and its working memory, as plain pointers. The files compiled for AVX must not
/// instantiate anything that the linker could share with code for other processors.
struct BatchRun {
  const Clause* code;
  std::size_t clauses;
  const float* constants;
  Operand root;
  const float* x;
  const float* y;
  const float* z;
  std::size_t count;   ///< number of points, at most `stride`
  float* scratch;      ///< slots * stride floats; for gradients 4 * slots * stride
  std::size_t stride;  ///< floats between slots; for gradients 64
};

/// Number of boxes whose intervals are evaluated together, one per lane.
inline constexpr std::size_t box_lanes = 16;

/// One interval per lane.
struct LaneRanges {
  float lower[box_lanes];
  float upper[box_lanes];
};

/// Lanes in which a min or max is proved to be its first argument or its second; for an absolute
/// value, its argument or its negative. If both bits of a lane are set, the first counts.
struct Choice {
  std::uint16_t first, second;
};

struct IntervalRun {
  const Clause* code;
  std::size_t clauses;
  const float* constants;
  Operand root;
  LaneRanges box[3];    ///< x, y and z; each lane contains some box
  std::size_t lanes;    ///< number of lanes with a valid box
  bool occupancy;       ///< choose by sign if only the sign matters (Boolean pruning)
  LaneRanges* scratch;  ///< one per slot
  Choice* choices;      ///< one per clause
};

/// apply() for intervals of numbers; false if the result is not finite or may be NaN.
bool finite_interval(Opcode op, float a_lower, float a_upper, float b_lower, float b_upper, float* out);

using RunValues = void (*)(const BatchRun&, float* out);
using RunGradients = void (*)(const BatchRun&, float* out, float* dx, float* dy, float* dz);
/// Writes the intervals of the root. Returns the lanes, one bit each, in which a number was not
/// finite. Their intervals and choices are invalid; use evaluate_ranges() for them.
using RunIntervals = std::uint32_t (*)(const IntervalRun&, LaneRanges& root);

/// A function for machine code: as many values as a vector has lanes, from the first vector registers
/// to the first one. (A cast: files without these instructions cannot name its type.)
using RegisterFunction = void (*)();

/// Part of an operation for machine code, for as many points as a vector has lanes, n. For partial
/// derivatives, `in` holds n first and n second arguments and n values, and `out` gets n derivatives
/// by the first and n by the second argument. For intervals, `in` holds n lower and n upper ends of
/// the first and of the second arguments, and `out` gets n lower and n upper ends and n marks, with
/// all bits set if a number is not finite.
using LaneOperation = void (*)(const float* in, float* out);

/// The evaluators for one instruction set.
struct Runners {
  RunValues values;
  RunGradients gradients;
  RunIntervals intervals;
  RegisterFunction (*operation)(Opcode);  ///< null for the reference, as are the next two
  LaneOperation (*partials)(Opcode), (*lane_interval)(Opcode);
};
extern const Runners reference_runners, portable_runners, avx2_runners, avx512_runners;

}  // namespace fieldfab::frep
