#include "fieldfab/frep/frep_field.h"

#include <algorithm>
#include <cmath>

#include "batch.h"
#include "fieldfab/core/error.h"
#include "frame.h"
#include "tape.h"

namespace fieldfab::frep {

void run_values_reference(const BatchRun& run, float* out) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const auto value = [&](Operand operand) {
      if ((operand & constant_bit) != 0) return run.constants[operand & ~constant_bit];
      return operand == 0   ? run.x[i]
             : operand == 1 ? run.y[i]
             : operand == 2 ? run.z[i]
                            : run.scratch[run.slot[operand - first_value]];
    };
    for (std::size_t c = 0; c < run.clauses; ++c)
      run.scratch[run.slot[c]] = apply(run.code[c].op, value(run.code[c].a), value(run.code[c].b));
    out[i] = value(run.root);
  }
}

namespace {

struct Runner {
  RunValues values;
  RunGradients gradients;
};

Runner runner(Evaluator evaluator) {
  switch (evaluator) {
    case Evaluator::reference: return {run_values_reference, run_gradients_portable};
    case Evaluator::avx2: return {run_values_avx2, run_gradients_avx2};
    case Evaluator::avx512: return {run_values_avx512, run_gradients_avx512};
    default: return {run_values_portable, run_gradients_portable};
  }
}

/// The interval of the floats that coordinates from `box` round to.
Interval range(const Box& box, int axis) {
  return {static_cast<float>(box.lower[axis]), static_cast<float>(box.upper[axis]), false};
}

class FrepField final : public Field {
 public:
  FrepField(Tape tape, Runner run, std::optional<Expression> expression = {})
      : tape_(std::move(tape)), run_(run), expression_(std::move(expression)) {}

  void values(const Points& points, float* out) const noexcept override {
    // Slots of a batch should stay in the first-level cache, but loops want some length.
    constexpr std::size_t cache_floats = 6144;
    const std::size_t stride = std::clamp(cache_floats / (tape_.slots + 1) / 16 * 16, std::size_t{64}, std::size_t{512});
    float* scratch = scratch_floats(tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      run_.values(batch(points, first, std::min(stride, points.count - first), scratch, stride), out + first);
  }

  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    constexpr std::size_t stride = 64;
    float* scratch = scratch_floats(4 * tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      run_.gradients(batch(points, first, std::min(stride, points.count - first), scratch, stride), out + first,
                     slopes.dx + first, slopes.dy + first, slopes.dz + first);
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    return evaluate_ranges(tape_, range(box, 0), range(box, 1), range(box, 2), ranges());
  }

  [[nodiscard]] Restriction restricted(const Box& box, Purpose purpose) const override {
    Ranges& known = ranges();
    const Interval root = evaluate_ranges(tape_, range(box, 0), range(box, 1), range(box, 2), known);
    Tape pruned;
    if (root.decided() || !prune(tape_, known, purpose, pruned)) return {root, shared_from_this()};
    return {root, std::make_shared<FrepField>(std::move(pruned), run_)};
  }

  [[nodiscard]] Framed framed() const override {
    const std::optional<FramedExpression> own = expression_ ? in_own_frame(*expression_) : std::nullopt;
    if (!own) return Field::framed();
    return {std::make_shared<FrepField>(make_tape(own->expression), run_), own->axes, Vec3::Zero()};
  }

  [[nodiscard]] bool affine() const noexcept override { return is_affine(tape_); }
  [[nodiscard]] std::size_t cost() const noexcept override { return tape_.code.size() + 1; }
  [[nodiscard]] std::size_t active_nodes() const { return tape_.code.size(); }

 private:
  [[nodiscard]] BatchRun batch(const Points& points, std::size_t first, std::size_t count, float* scratch,
                               std::size_t stride) const {
    return {tape_.code.data(),
            tape_.slot.data(),
            tape_.code.size(),
            tape_.constants.data(),
            tape_.root,
            points.x + first,
            points.y + first,
            points.z + first,
            count,
            scratch,
            stride};
  }

  /// Memory that each thread keeps for its batches; a deep expression may have taken much, which is given back here.
  static float* scratch_floats(std::size_t count) {
    static thread_local std::vector<float> scratch;
    constexpr std::size_t keep = std::size_t{1} << 22;
    if (scratch.size() < count || (scratch.size() > keep && count < keep)) {
      scratch = {};
      scratch.resize(count);
    }
    return scratch.data();
  }
  static Ranges& ranges() {
    static thread_local Ranges kept;
    return kept;
  }

  Tape tape_;
  Runner run_;
  std::optional<Expression> expression_;  ///< what the tape was made from; restrictions have none
};

}  // namespace

Evaluator best_evaluator() {
  if (available(Evaluator::avx512)) return Evaluator::avx512;
  if (available(Evaluator::avx2)) return Evaluator::avx2;
  return Evaluator::portable;
}

bool available(Evaluator evaluator) {
#if defined(__x86_64__)
  if (evaluator == Evaluator::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (evaluator == Evaluator::avx2) return __builtin_cpu_supports("avx2") != 0;
#else
  if (evaluator == Evaluator::avx512 || evaluator == Evaluator::avx2) return false;
#endif
  return true;
}

std::string_view name(Evaluator evaluator) {
  switch (evaluator) {
    case Evaluator::automatic: return "automatic";
    case Evaluator::reference: return "reference";
    case Evaluator::portable: return "portable";
    case Evaluator::avx2: return "avx2";
    case Evaluator::avx512: return "avx512";
  }
  return "?";
}

FieldPtr make_field(const Expression& expression, Evaluator evaluator) {
  if (evaluator == Evaluator::automatic) evaluator = best_evaluator();
  if (!available(evaluator))
    throw Error(ErrorKind::bad_input, "evaluator", std::string(name(evaluator)) + " does not run on this processor");
  return std::make_shared<FrepField>(make_tape(expression), runner(evaluator), expression);
}

std::size_t active_nodes(const Field& field) {
  const auto* frep = dynamic_cast<const FrepField*>(&field);
  return frep != nullptr ? frep->active_nodes() : 0;
}

}  // namespace fieldfab::frep
