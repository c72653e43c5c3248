#include "fieldfab/frep/frep_field.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include "compiled_tape.h"
#include "fieldfab/core/error.h"
#include "frame.h"
#include "jumps.h"
#include "mixed_field.h"
#include "prune.h"
#include "ranges.h"
#include "scratch.h"
#include "seams.h"
#include "slopes.h"

namespace fieldfab::frep {

namespace {

/// Evaluators of a tape.
struct Engine {
  const Runners* interpreter;
  std::size_t jit_lanes = 0;  ///< 0: no machine code
  bool always_jit = false;    ///< whether a tape is compiled before its first use, instead of after frequent use
};

Engine engine(Evaluator evaluator) {
  switch (evaluator) {
    case Evaluator::reference: return {&reference_runners};
    case Evaluator::portable: return {&portable_runners};
    case Evaluator::avx2: return {&avx2_runners};
    case Evaluator::avx512: return {&avx512_runners};
    case Evaluator::jit_avx2: return {&avx2_runners, 8, true};
    case Evaluator::jit_avx512: return {&avx512_runners, 16, true};
    case Evaluator::automatic: break;
  }
  if (available(Evaluator::avx512)) return {&avx512_runners, 16};
  if (available(Evaluator::avx2)) return {&avx2_runners, 8};
  return {&portable_runners};
}

/// Machine code that is compiled once a tape has been evaluated at so many points that compilation
/// pays.
class LazyCode {
 public:
  ~LazyCode() { delete code_.load(); }
  LazyCode() = default;
  LazyCode(const LazyCode&) = delete;
  LazyCode& operator=(const LazyCode&) = delete;

  /// Returns the code, or null while interpretation is as good. One thread compiles; the others
  /// continue without waiting.
  const CompiledTape* after(std::size_t points, const Tape& tape, CompiledTape::Makes what,
                            const Engine& engine) const {
    if (const CompiledTape* code = code_.load(std::memory_order_acquire)) return code;
    if (engine.jit_lanes == 0) return nullptr;
    // Compilation takes as long as interpretation of some thousand points, plus a constant time to
    // make memory executable.
    const std::size_t pays = 2000 + 500000 / (tape.code.size() + 1);
    const std::size_t seen = points_.fetch_add(points, std::memory_order_relaxed) + points;
    if (!engine.always_jit && seen < pays) return nullptr;
    if (tried_.exchange(true)) return nullptr;
    code_.store(CompiledTape::compile(tape, what, engine.jit_lanes, *engine.interpreter).release(),
                std::memory_order_release);
    return code_.load();
  }

 private:
  mutable std::atomic<std::size_t> points_{0};
  mutable std::atomic<bool> tried_{false};
  mutable std::atomic<const CompiledTape*> code_{nullptr};
};

/// Interval of the floats that coordinates in `box` round to.
Interval range(const Box& box, int axis) {
  return {static_cast<float>(box.lower[axis]), static_cast<float>(box.upper[axis]), false};
}

class FrepField final : public Field {
 public:
  FrepField(Tape tape, const Engine& engine, std::optional<Expression> expression = {})
      : tape_(std::move(tape)), engine_(engine), expression_(std::move(expression)), has_jumps_(has_jumps(tape_)) {}

  void values(const Points& points, float* out) const noexcept override {
    if (const CompiledTape* code = values_code_.after(points.count, tape_, CompiledTape::Makes::values, engine_))
      return code->run(points, {out});
    // The slots of a batch should stay in the first-level cache, but loops need some length.
    constexpr std::size_t cache_floats = 6144;
    const std::size_t stride =
        std::clamp(cache_floats / (tape_.slots + 1) / 16 * 16, std::size_t{64}, std::size_t{512});
    auto* const space = scratch<float>(tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      engine_.interpreter->values(batch(points, first, std::min(stride, points.count - first), space, stride),
                                  out + first);
  }

  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    // A gradient costs as much as several values.
    if (const CompiledTape* code =
            gradients_code_.after(8 * points.count, tape_, CompiledTape::Makes::gradients, engine_))
      return code->run(points, {out, slopes.dx, slopes.dy, slopes.dz});
    constexpr std::size_t stride = 64;
    auto* const space = scratch<float>(4 * tape_.slots * stride);
    for (std::size_t first = 0; first < points.count; first += stride)
      engine_.interpreter->gradients(batch(points, first, std::min(stride, points.count - first), space, stride),
                                     out + first, slopes.dx + first, slopes.dy + first, slopes.dz + first);
  }

  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    std::array<Box, most_pieces> pieces;
    const std::size_t count = has_jumps_ ? divide_at_jumps(tape_, box, pieces) : 1;
    if (count == 1) return ranges_over(box);
    std::array<Interval, most_pieces> ranges;
    for (std::size_t i = 0; i < count; ++i) ranges[i] = ranges_over(pieces[i]);
    return hull({ranges.data(), count});
  }

  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    static_cast<void>(ranges_over(box));
    for (std::size_t first = 0; first < directions.size(); first += slope_lanes)
      evaluate_slopes(tape_, kept_ranges(), directions.subspan(first, std::min(slope_lanes, directions.size() - first)),
                      out.subspan(first));
  }

  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    for (std::size_t first = 0; first < boxes.size(); first += box_lanes) {
      const std::size_t count = std::min(box_lanes, boxes.size() - first);
      restrict_lanes(boxes.subspan(first, count), purpose, out.subspan(first, count));
    }
  }

  using Field::framed;
  [[nodiscard]] Framed framed(Purpose purpose) const override {
    const std::optional<FramedExpression> own = expression_ ? in_own_frame(*expression_) : std::nullopt;
    if (!own) return Field::framed(purpose);
    return {std::make_shared<FrepField>(make_tape(own->expression), engine_), own->axes, Vec3::Zero()};
  }

  [[nodiscard]] FieldPtr without_seams() const override {
    std::call_once(merged_once_, [this] {
      Tape merged;
      if (merge_seams(tape_, merged)) merged_ = std::make_shared<FrepField>(std::move(merged), engine_);
    });
    return merged_;
  }

  [[nodiscard]] bool affine() const noexcept override { return is_affine(tape_); }
  [[nodiscard]] unsigned unread_axes() const noexcept override { return frep::unread_axes(tape_); }
  [[nodiscard]] std::size_t cost() const noexcept override { return tape_.code.size() + 1; }
  [[nodiscard]] std::size_t active_nodes() const { return tape_.code.size(); }

 private:
  /// The ranges and choices of several boxes, one a lane.
  struct LaneRun {
    std::array<Interval, box_lanes> ranges;
    Choice* choices;  ///< valid until the next evaluation in this thread
  };

  /// `decided_too`: choices also of boxes that the root's range decides.
  [[nodiscard]] LaneRun evaluate(std::span<const Box> boxes, Purpose purpose, bool decided_too) const {
    IntervalRun run{tape_.code.data(),
                    tape_.code.size(),
                    tape_.constants.data(),
                    tape_.root,
                    {},
                    boxes.size(),
                    purpose == Purpose::occupancy,
                    scratch<LaneRanges>(tape_.slots),
                    scratch<Choice>(tape_.code.size())};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      LaneRanges& side = run.box[axis];
      for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
        const Interval of_box = range(boxes[lane], static_cast<int>(axis));
        side.lower[lane] = of_box.lower, side.upper[lane] = of_box.upper;
      }
      std::fill(side.lower + boxes.size(), side.lower + box_lanes, side.lower[0]);
      std::fill(side.upper + boxes.size(), side.upper + box_lanes, side.upper[0]);
    }
    LaneRanges root;
    const bool occupancy = purpose == Purpose::occupancy;
    const CompiledTape* const code =
        (occupancy ? sign_intervals_code_ : intervals_code_)
            .after(16 * boxes.size(), tape_,
                   occupancy ? CompiledTape::Makes::sign_intervals : CompiledTape::Makes::intervals, engine_);
    const std::uint32_t wild = code != nullptr ? code->run(run, root) : engine_.interpreter->intervals(run, root);
    LaneRun found{{}, run.choices};
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
      Interval& range = found.ranges[lane];
      range = {root.lower[lane], root.upper[lane], false};
      if ((wild >> lane & 1U) != 0) {
        range = ranges_over(boxes[lane]);
        if (decided_too || !range.decided())
          record_choices(tape_, kept_ranges(), purpose, static_cast<unsigned>(lane), run.choices);
      }
    }
    return found;
  }

  void restrict_lanes(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const {
    const LaneRun run = evaluate(boxes, purpose, false);
    bool any = false;
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
      out[lane] = {run.ranges[lane], *this};
      any |= !out[lane].range.decided();
    }
    if (!any) return;
    std::vector<std::uint16_t>& needed = kept_needed();
    const unsigned simpler = mark_needed(tape_, run.choices, needed);
    for (std::size_t lane = 0; lane < boxes.size(); ++lane)
      if (!out[lane].range.decided() && (simpler >> lane & 1U) != 0) out[lane].field = pruned(run, needed, lane);
    if (!has_jumps_) return;
    for (std::size_t lane = 0; lane < boxes.size(); ++lane)
      if (!out[lane].range.decided()) restrict_pieces(boxes[lane], purpose, out[lane]);
  }

  /// Restricts to a box with jumps by its pieces without: what holds in all of them.
  void restrict_pieces(const Box& box, Purpose purpose, Restriction& out) const {
    std::array<Box, most_pieces> pieces;
    const std::size_t count = divide_at_jumps(tape_, box, pieces);
    if (count == 1) return;
    const LaneRun run = evaluate({pieces.data(), count}, purpose, true);
    out.range = hull({run.ranges.data(), count});
    if (out.range.decided()) return;
    const auto all = static_cast<std::uint16_t>((1U << count) - 1);
    for (std::size_t i = 0; i < tape_.code.size(); ++i) {
      Choice& choice = run.choices[i];
      const bool first = (choice.first & all) == all, second = !first && ((choice.second & ~choice.first) & all) == all;
      choice = {static_cast<std::uint16_t>(first ? 1 : 0), static_cast<std::uint16_t>(second ? 1 : 0)};
    }
    std::vector<std::uint16_t>& needed = kept_needed();
    const bool simpler = (mark_needed(tape_, run.choices, needed) & 1U) != 0;
    if (simpler)
      out.field = pruned(run, needed, 0);
    else
      out.field = *this;
  }

  [[nodiscard]] FieldPtr pruned(const LaneRun& run, const std::vector<std::uint16_t>& needed, std::size_t lane) const {
    Tape left;
    prune(tape_, run.choices, needed, static_cast<unsigned>(lane), left);
    return std::make_shared<FrepField>(std::move(left), engine_);
  }

  static std::vector<std::uint16_t>& kept_needed() {
    static thread_local std::vector<std::uint16_t> kept;
    return kept;
  }

  static Interval hull(std::span<const Interval> ranges) {
    Interval all = ranges.front();
    for (const Interval& range : ranges)
      all = {std::min(all.lower, range.lower), std::max(all.upper, range.upper), all.maybe_nan || range.maybe_nan};
    return all;
  }

  /// Computes the intervals of all values over a box, in kept_ranges().
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
            tape_.constants.data(),
            tape_.root,
            points.x + first,
            points.y + first,
            points.z + first,
            count,
            space,
            stride};
  }

  Tape tape_;
  Engine engine_;
  std::optional<Expression> expression_;  ///< source of the tape; restrictions have none
  bool has_jumps_;
  mutable std::once_flag merged_once_;
  mutable FieldPtr merged_;  ///< without seams
  LazyCode values_code_, gradients_code_, intervals_code_, sign_intervals_code_;
};

}  // namespace

bool available(Evaluator evaluator) {
#if defined(__x86_64__)
  if (evaluator == Evaluator::avx512 || evaluator == Evaluator::jit_avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  if (evaluator == Evaluator::avx2 || evaluator == Evaluator::jit_avx2) return __builtin_cpu_supports("avx2") != 0;
#else
  if (evaluator > Evaluator::portable) return false;
#endif
  return true;
}

namespace {

constexpr std::array<std::string_view, 7> evaluator_names{"automatic", "reference", "portable",  "avx2",
                                                          "avx512",    "jit-avx2",  "jit-avx512"};
std::atomic<Evaluator> default_evaluator{Evaluator::automatic};

void require(Evaluator evaluator) {
  if (!available(evaluator))
    throw Error(ErrorKind::bad_input, "evaluator", std::string(name(evaluator)) + " does not run on this processor");
}

}  // namespace

std::string_view name(Evaluator evaluator) { return evaluator_names[static_cast<std::size_t>(evaluator)]; }

Evaluator evaluator_named(std::string_view name) {
  if (name == "jit") return available(Evaluator::jit_avx512) ? Evaluator::jit_avx512 : Evaluator::jit_avx2;
  const auto* const found = std::find(evaluator_names.begin(), evaluator_names.end(), name);
  if (found == evaluator_names.end())
    throw Error(ErrorKind::bad_input, "evaluator",
                "'" + std::string(name) +
                    "' is none of automatic, reference, portable, avx2, avx512, jit, jit-avx2, jit-avx512");
  return static_cast<Evaluator>(found - evaluator_names.begin());
}

void set_default_evaluator(Evaluator evaluator) {
  require(evaluator);
  default_evaluator = evaluator;
}

FieldPtr make_field(const Expression& expression, Evaluator evaluator) {
  if (evaluator == Evaluator::automatic) evaluator = default_evaluator;
  require(evaluator);
  const auto make_pure = [&](const Expression& pure) -> FieldPtr {
    return std::make_shared<FrepField>(make_tape(pure), engine(evaluator), pure);
  };
  return has_opened(expression) ? make_mixed_field(expression, make_pure) : make_pure(expression);
}

std::size_t active_nodes(const Field& field) {
  const auto* frep = dynamic_cast<const FrepField*>(&field);
  return frep != nullptr ? frep->active_nodes() : 0;
}

}  // namespace fieldfab::frep
