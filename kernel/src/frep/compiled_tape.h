/// A tape as machine code.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "batch.h"
#include "code_memory.h"
#include "fieldfab/field/field.h"
#include "tape.h"

namespace fieldfab::frep {

/// Machine code for one tape, made by asmjit. Results equal those of the batch evaluators, bit for
/// bit.
class CompiledTape {
 public:
  /// `intervals` choose by value, `sign_intervals` by sign if only the sign matters (see
  /// IntervalRun::occupancy).
  enum class Makes { values, gradients, intervals, sign_intervals };

  /// `lanes` is 8 for AVX2 and 16 for AVX-512; the processor must support it. `helpers` compute
  /// operations without an instruction. Returns null if there is no executable memory, or for
  /// intervals with a constant that is not finite. Linear in the size of the tape.
  static std::unique_ptr<const CompiledTape> compile(const Tape& tape, Makes what, std::size_t lanes,
                                                     const Runners& helpers);

  /// Writes values, or gradients in the order value, d/dx, d/dy, d/dz.
  void run(const Points& points, const std::array<float*, 4>& out) const noexcept;

  /// Evaluates intervals like RunIntervals.
  std::uint32_t run(const IntervalRun& run, LaneRanges& root) const noexcept;

 private:
  CompiledTape(std::unique_ptr<CodeMemory> code, Makes what, std::size_t lanes, std::size_t frame_vectors)
      : code_(std::move(code)),
        outs_(what == Makes::values ? 1 : 4),
        lanes_(lanes),
        frame_floats_(frame_vectors * lanes) {}

  std::unique_ptr<CodeMemory> code_;
  std::size_t outs_, lanes_, frame_floats_;
};

}  // namespace fieldfab::frep
