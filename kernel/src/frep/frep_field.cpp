#include "fieldfab/frep/frep_field.h"

#include <algorithm>
#include <cmath>

#include "batch.h"
#include "fieldfab/core/error.h"
#include "frame.h"
#include "prune.h"
#include "ranges.h"

namespace fieldfab::frep {

namespace {

const Runners& runners(Evaluator evaluator) {
  switch (evaluator) {
    case Evaluator::reference: return reference_runners;
    case Evaluator::avx2: return avx2_runners;
    case Evaluator::avx512: return avx512_runners;
    default: return portable_runners;
  }
}

/// Memory that each thread keeps for its batches; a deep expression may have taken much, which is given back here.
template <class T>
T* scratch(std::size_t count) {
  static thread_local std::vector<T> kept;
  std::vector<T>& memory = kept;
  constexpr std::size_t keep = (std::size_t{1} << 24) / sizeof(T);
  if (memory.size() < count || (memory.size() > keep && count < keep)) {
    memory = {};
    memory.resize(count);
  }
  return memory.data();
}

/// The interval of the floats that coordinates from `box` round to.
Interval range(const Box& box, int axis) {
  return {static_cast<float>(box.lower[axis]), static_cast<float>(box.upper[axis]), false};
}

class FrepField final : public Field {
 public:
  FrepField(Tape tape, const Runners& run, std::optional<Expression> expression = {})
      : tape_(std::move(tape)), run_(run), expression_(std::move(expression)) {}

  void values(const Points& points, float* out) const noexcept override {
    // Slots of a batch should stay in the first-level cache, but loops want some length.
    constexpr std::size_t cache_floats = 6144;
    const std::size_t stride = std::clamp(cache_floats / (tape_.slots + 1) / 16 * 16, std::size_t{64}, std::size_t{512});
    auto* const space = scratch<float>(tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      run_.values(batch(points, first, std::min(stride, points.count - first), space, stride), out + first);
  }

  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    constexpr std::size_t stride = 64;
    auto* const space = scratch<float>(4 * tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      run_.gradients(batch(points, first, std::min(stride, points.count - first), space, stride), out + first,
                     slopes.dx + first, slopes.dy + first, slopes.dz + first);
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return ranges_over(box); }

  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    for (std::size_t first = 0; first < boxes.size(); first += box_lanes) {
      const std::size_t count = std::min(box_lanes, boxes.size() - first);
      restrict_lanes(boxes.subspan(first, count), purpose, out.subspan(first, count));
    }
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
  void restrict_lanes(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const {
    IntervalRun run{tape_.code.data(),
                    tape_.code.size(),
                    tape_.constants->data(),
                    tape_.root,
                    {},
                    boxes.size(),
                    purpose == Purpose::occupancy,
                    scratch<LaneRanges>(tape_.slots),
                    scratch<Choice>(tape_.code.size())};
    for (std::size_t lane = 0; lane < box_lanes; ++lane)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Interval side = range(boxes[std::min(lane, boxes.size() - 1)], static_cast<int>(axis));
        run.box[axis].lower[lane] = side.lower;
        run.box[axis].upper[lane] = side.upper;
      }
    LaneRanges root;
    const std::uint32_t wild = run_.intervals(run, root);
    bool any = false;
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
      Interval& range = out[lane].range;
      range = {root.lower[lane], root.upper[lane], false};
      out[lane].field = shared_from_this();
      if ((wild >> lane & 1U) != 0) {
        range = ranges_over(boxes[lane]);
        if (!range.decided()) record_choices(tape_, kept_ranges(), purpose, static_cast<unsigned>(lane), run.choices);
      }
      any |= !range.decided();
    }
    if (!any) return;
    static thread_local std::vector<std::uint16_t> kept_needed;
    std::vector<std::uint16_t>& needed = kept_needed;
    mark_needed(tape_, run.choices, needed);
    for (std::size_t lane = 0; lane < boxes.size(); ++lane)
      if (Tape pruned; !out[lane].range.decided() && prune(tape_, run.choices, needed, static_cast<unsigned>(lane), pruned))
        out[lane].field = std::make_shared<FrepField>(std::move(pruned), run_);
  }

  /// The intervals of all values over a box are left in kept_ranges().
  [[nodiscard]] Interval ranges_over(const Box& box) const noexcept {
    return evaluate_ranges(tape_, range(box, 0), range(box, 1), range(box, 2), kept_ranges());
  }
  static Ranges& kept_ranges() {
    static thread_local Ranges kept;
    return kept;
  }

  [[nodiscard]] BatchRun batch(const Points& points, std::size_t first, std::size_t count, float* space,
                               std::size_t stride) const {
    return {tape_.code.data(),
            tape_.code.size(),
            tape_.constants->data(),
            tape_.root,
            points.x + first,
            points.y + first,
            points.z + first,
            count,
            space,
            stride};
  }

  Tape tape_;
  const Runners& run_;
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
  return std::make_shared<FrepField>(make_tape(expression), runners(evaluator), expression);
}

std::size_t active_nodes(const Field& field) {
  const auto* frep = dynamic_cast<const FrepField*>(&field);
  return frep != nullptr ? frep->active_nodes() : 0;
}

}  // namespace fieldfab::frep
