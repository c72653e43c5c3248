#include "compiled_tape.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "scratch.h"
#include "vector_assembler.h"

namespace fieldfab::frep {
namespace {

namespace x86 = asmjit::x86;
namespace Inst = x86::Inst;
using Vec = VectorAssembler::Vec;

/// Returns the instruction of an operation that has one of the form to = a op b.
std::optional<Inst::Id> instruction(Opcode op) {
  switch (op) {
    case Opcode::add: return Inst::kIdVaddps;
    case Opcode::subtract: return Inst::kIdVsubps;
    case Opcode::multiply:
    case Opcode::square: return Inst::kIdVmulps;
    case Opcode::divide: return Inst::kIdVdivps;
    default: return std::nullopt;
  }
}

/// Emits to = op(a, b). `to` may be a or b; the temporary s must not; the mask m may be a. Returns
/// false if there are no instructions for the operation.
bool emit_value(VectorAssembler& out, Opcode op, const Vec& to, const Vec& a, const Vec& b, const Vec& s,
                const VectorAssembler::Mask& m) {
  if (const auto simple = instruction(op)) return out.binary(*simple, to, a, op == Opcode::square ? a : b), true;
  switch (op) {
    case Opcode::minimum: return out.least(to, a, b, s, m), true;
    case Opcode::maximum: return out.greatest(to, a, b, s, m), true;
    case Opcode::absolute: return out.magnitude(to, a), true;
    case Opcode::negate: return out.negate(to, a), true;
    case Opcode::square_root: return out.unary(Inst::kIdVsqrtps, to, a), true;
    case Opcode::floor: return out.floor(to, a), true;
    case Opcode::ceiling: return out.ceiling(to, a), true;
    case Opcode::modulo:
      out.binary(Inst::kIdVdivps, s, a, b);
      out.floor(s, s);
      out.binary(Inst::kIdVmulps, s, b, s);
      out.binary(Inst::kIdVsubps, to, a, s);
      return true;
    default: return false;
  }
}

/// Code for values: the first slots are in registers, the others in the frame. A call overwrites all
/// registers: what is needed later is in the frame from then on, until its slot gets another value.
class ValuesCode {
 public:
  ValuesCode(VectorAssembler& out, const Tape& tape, const Runners& helpers)
      : out_(out), tape_(tape), helpers_(helpers), last_use_(tape.code.size()) {
    for (std::size_t i = 0; i < tape.code.size(); ++i)
      for (const Operand operand : {tape.code[i].a, tape.code[i].b})
        if (is_made(operand)) last_use_[operand - first_value] = i;
    if (is_made(tape.root)) last_use_[tape.root - first_value] = tape.code.size();
  }

  void emit() {
    out_.begin(3);
    for (std::size_t i = 0; i < tape_.code.size(); ++i) emit(i);
    out_.store_out(0, in_register(tape_.root, a_));
    out_.end();
  }

 private:
  asmjit::Operand place(Operand operand) {
    if (is_constant(operand)) return out_.constant(tape_.constants[operand & ~constant_bit]);
    if (!is_made(operand)) return out_.frame(static_cast<int>(operand));
    const std::uint32_t slot = tape_.code[operand - first_value].slot;
    if (slot < slot_registers_ && in_registers_[slot]) return out_.vector(static_cast<int>(slot));
    return in_frame(slot);
  }
  asmjit::x86::Mem in_frame(std::uint32_t slot) const {
    return out_.frame(VectorAssembler::frame_slots + static_cast<int>(slot));
  }
  Vec in_register(Operand operand, const Vec& otherwise) {
    const asmjit::Operand where = place(operand);
    if (where.isReg()) return where.as<Vec>();
    out_.load(otherwise, where);
    return otherwise;
  }

  void emit(std::size_t i) {
    const Clause& clause = tape_.code[i];
    const bool has_register = clause.slot < slot_registers_;
    const Vec to = has_register ? out_.vector(static_cast<int>(clause.slot)) : made_;
    const auto simple = instruction(clause.op);
    const Vec a = in_register(clause.a, a_);
    if (simple && clause.b != clause.a) {
      out_.binary(*simple, to, a, place(clause.b));
    } else {
      const Vec b = clause.b == clause.a ? a : in_register(clause.b, b_);
      if (!emit_value(out_, clause.op, to, a, b, made_, out_.mask(static_cast<int>(slot_registers_))))
        call(i, a, b, to);
    }
    if (has_register)
      in_registers_[clause.slot] = true, holds_[clause.slot] = i;
    else
      out_.store(in_frame(clause.slot), to);
  }

  void call(std::size_t i, const Vec& a, const Vec& b, const Vec& to) {
    for (std::uint32_t slot = 0; slot < slot_registers_; ++slot)
      if (in_registers_[slot] && last_use_[holds_[slot]] > i)
        out_.store(in_frame(slot), out_.vector(static_cast<int>(slot)));
    out_.load(a_, a);
    if (arity(tape_.code[i].op) == 2) out_.load(b_, b);
    out_.call(helpers_.operation(tape_.code[i].op), a_, b_);
    in_registers_.fill(false);
    out_.load(to, out_.vector(0));
  }

  VectorAssembler& out_;
  const Tape& tape_;
  const Runners& helpers_;
  std::vector<std::size_t> last_use_;    ///< the last clause that uses the value of a clause
  std::array<bool, 32> in_registers_{};  ///< by slot
  std::array<std::size_t, 32> holds_{};  ///< the clause whose value a slot's register holds
  // The last three registers hold operands that are not in a register.
  const std::uint32_t slot_registers_ = static_cast<std::uint32_t>(out_.registers() - 3);
  const Vec a_ = out_.vector(out_.registers() - 3), b_ = out_.vector(out_.registers() - 2),
            made_ = out_.vector(out_.registers() - 1);
};

/// Code for values and slopes: four vectors per slot, all in the frame. Slopes that are zero
/// everywhere are left out.
class GradientsCode {
 public:
  GradientsCode(VectorAssembler& out, const Tape& tape, const Runners& helpers)
      : out_(out), tape_(tape), helpers_(helpers), axes_(tape.code.size()) {}

  void emit() {
    out_.begin(3);
    for (std::size_t i = 0; i < tape_.code.size(); ++i) emit(tape_.code[i], axes_[i]);
    out_.load(value_, value(tape_.root));
    out_.store_out(0, value_);
    for (int axis = 0; axis < 3; ++axis) {
      out_.load(value_, slope(tape_.root, axis));
      out_.store_out(1 + axis, value_);
    }
    out_.end();
  }

 private:
  asmjit::Operand value(Operand operand) {
    if (is_constant(operand)) return out_.constant(tape_.constants[operand & ~constant_bit]);
    if (!is_made(operand)) return out_.frame(static_cast<int>(operand));
    return slot(tape_.code[operand - first_value].slot, 0);
  }
  asmjit::Operand slope(Operand operand, int axis) {
    if (!varies(operand, axis)) return out_.constant(0);
    if (!is_made(operand)) return out_.constant(1);
    return slot(tape_.code[operand - first_value].slot, 1 + axis);
  }
  [[nodiscard]] x86::Mem slot(std::uint32_t number, int part) const {
    return out_.frame(VectorAssembler::frame_slots + 4 * static_cast<int>(number) + part);
  }
  [[nodiscard]] bool varies(Operand operand, int axis) const {
    if (is_constant(operand)) return false;
    return is_made(operand) ? (axes_[operand - first_value] >> axis & 1) != 0 : static_cast<int>(operand) == axis;
  }

  void emit(const Clause& clause, std::uint8_t& axes) {
    const bool two = arity(clause.op) == 2;
    for (int axis = 0; axis < 3; ++axis)
      if (varies(clause.a, axis) || (two && varies(clause.b, axis))) axes = static_cast<std::uint8_t>(axes | 1 << axis);
    if (clause.op == Opcode::floor || clause.op == Opcode::ceiling || clause.op == Opcode::compare) axes = 0;

    out_.load(a_, value(clause.a));
    out_.load(b_, value(clause.b));
    if (!emit_value(out_, clause.op, value_, a_, b_, t_, out_.mask(7))) {
      out_.call(helpers_.operation(clause.op), a_, b_);
      out_.load(value_, out_.vector(0));
      out_.load(a_, value(clause.a)), out_.load(b_, value(clause.b));
    }
    const std::uint8_t wanted = axes;
    if (wanted != 0) prepare(clause);
    // All slopes are computed before any is stored, since the slot may be that of an argument.
    for (int axis = 0; axis < 3; ++axis)
      if ((wanted >> axis & 1) != 0) emit_slope(clause, axis, made_[static_cast<std::size_t>(axis)]);
    out_.store(slot(clause.slot, 0), value_);
    for (int axis = 0; axis < 3; ++axis)
      if ((wanted >> axis & 1) != 0) out_.store(slot(clause.slot, 1 + axis), made_[static_cast<std::size_t>(axis)]);
  }

  /// Emits the partial derivatives in a_ and b_ (see derivative.h), and masks of those that are not
  /// 0.
  void prepare(const Clause& clause) {
    switch (clause.op) {
      case Opcode::add:
      case Opcode::subtract:
      case Opcode::negate: return;
      case Opcode::minimum: return out_.compare(choice_, a_, b_, VectorAssembler::less_equal);
      case Opcode::maximum: return out_.compare(choice_, a_, b_, VectorAssembler::greater_equal);
      case Opcode::multiply: {
        out_.load(t_, a_), out_.load(a_, b_), out_.load(b_, t_);
        break;
      }
      case Opcode::square: out_.binary(Inst::kIdVaddps, a_, a_, a_); break;
      case Opcode::exponential: out_.load(a_, value_); break;
      case Opcode::arctangent:
      case Opcode::logarithm:
        if (clause.op == Opcode::arctangent) {
          out_.binary(Inst::kIdVmulps, a_, a_, a_);
          out_.binary(Inst::kIdVaddps, a_, a_, out_.constant(1));
        }
        out_.load(t_, out_.constant(1));
        out_.binary(Inst::kIdVdivps, a_, t_, a_);
        break;
      case Opcode::square_root:
        out_.load(t_, out_.constant(0.5F));
        out_.binary(Inst::kIdVdivps, a_, t_, value_);
        out_.compare(choice_, value_, out_.constant(0), VectorAssembler::greater);
        out_.keep(a_, choice_, a_);
        break;
      case Opcode::absolute:
        out_.load(t_, out_.constant(1));
        out_.compare(choice_, a_, out_.constant(0), VectorAssembler::greater);
        out_.compare(slope_counts_, a_, out_.constant(0), VectorAssembler::less);
        out_.keep(a_, choice_, t_);
        out_.keep(t_, slope_counts_, t_);
        out_.binary(Inst::kIdVsubps, a_, a_, t_);
        break;
      case Opcode::divide:
        out_.load(t_, out_.constant(1));
        out_.binary(Inst::kIdVdivps, a_, t_, b_);
        out_.negate(t_, value_);
        out_.binary(Inst::kIdVdivps, b_, t_, b_);
        break;
      default: {
        constexpr int in = VectorAssembler::frame_call;
        out_.store(out_.frame(in), a_), out_.store(out_.frame(in + 1), b_), out_.store(out_.frame(in + 2), value_);
        out_.call(helpers_.partials(clause.op), in, in + 3);
        out_.load(a_, out_.frame(in + 3)), out_.load(b_, out_.frame(in + 4)), out_.load(value_, out_.frame(in + 2));
      }
    }
    out_.compare(a_counts_, a_, out_.constant(0), VectorAssembler::not_equal);
    if (arity(clause.op) == 2) out_.compare(b_counts_, b_, out_.constant(0), VectorAssembler::not_equal);
  }

  /// Emits the slope along one axis in `to`.
  void emit_slope(const Clause& clause, int axis, const Vec& to) {
    const bool of_a = varies(clause.a, axis), of_b = arity(clause.op) == 2 && varies(clause.b, axis);
    switch (clause.op) {
      case Opcode::negate: out_.load(t_, slope(clause.a, axis)); return out_.negate(to, t_);
      case Opcode::add:
      case Opcode::subtract:
        out_.load(t_, slope(clause.a, axis));
        return out_.binary(clause.op == Opcode::add ? Inst::kIdVaddps : Inst::kIdVsubps, to, t_, slope(clause.b, axis));
      case Opcode::minimum:
      case Opcode::maximum:
        out_.load(t_, slope(clause.a, axis));
        out_.load(to, slope(clause.b, axis));
        return out_.select(to, choice_, t_, to);
      default:
        if (of_a) product(to, a_, a_counts_, slope(clause.a, axis));
        if (of_b) product(of_a ? t_ : to, b_, b_counts_, slope(clause.b, axis));
        if (of_a && of_b) out_.binary(Inst::kIdVaddps, to, to, t_);
    }
  }

  /// to = partial * slope, or 0 if either is 0 (see chain() in derivative.h).
  void product(const Vec& to, const Vec& partial, const VectorAssembler::Mask& counts, const asmjit::Operand& slope) {
    out_.load(to, slope);
    out_.compare(slope_counts_, to, out_.constant(0), VectorAssembler::not_equal);
    out_.binary(Inst::kIdVmulps, to, partial, to);
    out_.both(slope_counts_, slope_counts_, counts);
    out_.keep(to, slope_counts_, to);
  }

  VectorAssembler& out_;
  const Tape& tape_;
  const Runners& helpers_;
  std::vector<std::uint8_t> axes_;  ///< axes along which a clause's value may change, one bit each
  const Vec a_ = out_.vector(0), b_ = out_.vector(1), value_ = out_.vector(2), t_ = out_.vector(3);
  const std::array<Vec, 3> made_{out_.vector(4), out_.vector(5), out_.vector(6)};
  const VectorAssembler::Mask choice_ = out_.mask(8), a_counts_ = out_.mask(9), b_counts_ = out_.mask(10),
                              slope_counts_ = out_.mask(11);
};

/// Code for intervals: two vectors per slot, in the frame, with the same operations as
/// interval_loops.inl.
class IntervalsCode {
 public:
  IntervalsCode(VectorAssembler& out, const Tape& tape, const Runners& helpers, bool by_sign)
      : out_(out), tape_(tape), helpers_(helpers), by_sign_(by_sign) {}

  void emit() {
    out_.begin(6);
    out_.load(wild_, out_.constant(0));
    for (Operand axis = 0; axis < first_value; ++axis) {
      load(axis, a_);
      watch(a_);
    }
    for (std::size_t i = 0; i < tape_.code.size(); ++i) emit(i);
    load(tape_.root, a_);
    out_.store_out(0, a_.lower);
    out_.store_out(1, a_.upper);
    out_.store_out(2, wild_);
    out_.end();
  }

 private:
  struct Pair {
    Vec lower, upper;
  };

  void load(Operand operand, const Pair& to) {
    if (is_constant(operand)) {
      out_.load(to.lower, out_.constant(tape_.constants[operand & ~constant_bit]));
      out_.load(to.upper, to.lower);
      return;
    }
    const int place = is_made(operand) ? home(tape_.code[operand - first_value].slot) : 2 * static_cast<int>(operand);
    out_.load(to.lower, out_.frame(place));
    out_.load(to.upper, out_.frame(place + 1));
  }
  static int home(std::uint32_t slot) { return VectorAssembler::frame_slots + 2 * static_cast<int>(slot); }

  /// Records lanes that are not finite: the difference of the ends is infinite or NaN there, which
  /// are the largest bit patterns.
  void watch(const Pair& pair) {
    out_.binary(Inst::kIdVsubps, t_, pair.upper, pair.lower);
    out_.binary(Inst::kIdVpmaxud, wild_, wild_, t_);
  }

  void emit(std::size_t i) {
    const Clause& clause = tape_.code[i];
    load(clause.a, a_);
    load(clause.b, b_);
    const bool by_sign = by_sign_ && clause.only_sign_matters;
    switch (clause.op) {
      case Opcode::minimum:
        out_.binary(Inst::kIdVminps, made_.lower, a_.lower, b_.lower);
        out_.binary(Inst::kIdVminps, made_.upper, a_.upper, b_.upper);
        choose(i, false, a_.upper, b_.lower, VectorAssembler::less_equal, by_sign, b_.lower, VectorAssembler::greater);
        choose(i, true, b_.upper, a_.lower, VectorAssembler::less, by_sign, a_.lower, VectorAssembler::greater);
        break;
      case Opcode::maximum:
        out_.binary(Inst::kIdVmaxps, made_.lower, a_.lower, b_.lower);
        out_.binary(Inst::kIdVmaxps, made_.upper, a_.upper, b_.upper);
        choose(i, false, a_.lower, b_.upper, VectorAssembler::greater_equal, by_sign, b_.upper, VectorAssembler::less);
        choose(i, true, b_.lower, a_.upper, VectorAssembler::greater, by_sign, a_.upper, VectorAssembler::less);
        break;
      case Opcode::absolute:
        out_.compare(mask_, a_.lower, out_.constant(0), VectorAssembler::greater);
        out_.choose(i, false, mask_);
        out_.compare(mask_, a_.upper, out_.constant(0), VectorAssembler::less);
        out_.choose(i, true, mask_);
        out_.magnitude(b_.lower, a_.lower);
        out_.magnitude(b_.upper, a_.upper);
        fold();
        break;
      case Opcode::negate:
        out_.negate(made_.lower, a_.upper);
        out_.negate(made_.upper, a_.lower);
        break;
      case Opcode::add:
        out_.binary(Inst::kIdVaddps, made_.lower, a_.lower, b_.lower);
        out_.binary(Inst::kIdVaddps, made_.upper, a_.upper, b_.upper);
        watch(made_);
        break;
      case Opcode::subtract:
        out_.binary(Inst::kIdVsubps, made_.lower, a_.lower, b_.upper);
        out_.binary(Inst::kIdVsubps, made_.upper, a_.upper, b_.lower);
        watch(made_);
        break;
      case Opcode::multiply:
        if (clause.a == clause.b)
          square();
        else
          all_four(Inst::kIdVmulps);
        watch(made_);
        break;
      case Opcode::square:
        square();
        watch(made_);
        break;
      case Opcode::square_root:
        out_.compare(mask_, a_.lower, out_.constant(0), VectorAssembler::less);
        out_.mark(wild_, mask_);
        out_.unary(Inst::kIdVsqrtps, made_.lower, a_.lower);
        out_.unary(Inst::kIdVsqrtps, made_.upper, a_.upper);
        break;
      case Opcode::divide:
        out_.compare(mask_, b_.lower, out_.constant(0), VectorAssembler::less_equal);
        out_.compare(other_, b_.upper, out_.constant(0), VectorAssembler::greater_equal);
        out_.both(mask_, mask_, other_);
        out_.mark(wild_, mask_);
        all_four(Inst::kIdVdivps);
        watch(made_);
        break;
      default: call(clause.op);
    }
    out_.store(out_.frame(home(clause.slot)), made_.lower);
    out_.store(out_.frame(home(clause.slot) + 1), made_.upper);
  }

  /// Records the lanes in which the comparison of `first` with `second` holds, or by sign that of
  /// `alone` with 0.
  void choose(std::size_t clause, bool which, const Vec& first, const Vec& second, VectorAssembler::Predicate predicate,
              bool by_sign, const Vec& alone, VectorAssembler::Predicate sign) {
    out_.compare(mask_, first, second, predicate);
    if (by_sign) {
      out_.compare(other_, alone, out_.constant(0), sign);
      out_.either(mask_, mask_, other_);
    }
    out_.choose(clause, which, mask_);
  }

  void square() {
    out_.binary(Inst::kIdVmulps, b_.lower, a_.lower, a_.lower);
    out_.binary(Inst::kIdVmulps, b_.upper, a_.upper, a_.upper);
    fold();
  }
  /// Folds the images of the ends in b_: the least is 0 if a_ contains 0.
  void fold() {
    out_.binary(Inst::kIdVmaxps, made_.upper, b_.lower, b_.upper);
    out_.binary(Inst::kIdVminps, made_.lower, b_.lower, b_.upper);
    out_.compare(mask_, a_.lower, out_.constant(0), VectorAssembler::less_equal);
    out_.compare(other_, a_.upper, out_.constant(0), VectorAssembler::greater_equal);
    out_.both(mask_, mask_, other_);
    out_.load(t_, out_.constant(0));
    out_.select(made_.lower, mask_, t_, made_.lower);
  }
  /// Emits the least and the greatest of the products or quotients of the ends.
  void all_four(Inst::Id instruction) {
    const Vec lu = t_, ul = made_.lower, uu = made_.upper, ll = spare_;
    out_.binary(instruction, ll, a_.lower, b_.lower);
    out_.binary(instruction, lu, a_.lower, b_.upper);
    out_.binary(instruction, ul, a_.upper, b_.lower);
    out_.binary(instruction, uu, a_.upper, b_.upper);
    out_.binary(Inst::kIdVminps, a_.lower, ll, lu);
    out_.binary(Inst::kIdVminps, a_.upper, ul, uu);
    out_.binary(Inst::kIdVmaxps, b_.lower, ll, lu);
    out_.binary(Inst::kIdVmaxps, b_.upper, ul, uu);
    out_.binary(Inst::kIdVminps, made_.lower, a_.lower, a_.upper);
    out_.binary(Inst::kIdVmaxps, made_.upper, b_.lower, b_.upper);
  }

  void call(Opcode op) {
    constexpr int in = VectorAssembler::frame_call, made = in + 4, kept = in + 7;
    out_.store(out_.frame(in), a_.lower), out_.store(out_.frame(in + 1), a_.upper);
    out_.store(out_.frame(in + 2), b_.lower), out_.store(out_.frame(in + 3), b_.upper);
    out_.store(out_.frame(kept), wild_);
    out_.call(helpers_.lane_interval(op), in, made);
    out_.load(made_.lower, out_.frame(made)), out_.load(made_.upper, out_.frame(made + 1));
    out_.load(wild_, out_.frame(kept));
    out_.binary(Inst::kIdVorps, wild_, wild_, out_.frame(made + 2));
  }

  VectorAssembler& out_;
  const Tape& tape_;
  const Runners& helpers_;
  const bool by_sign_;
  const Pair a_{out_.vector(0), out_.vector(1)}, b_{out_.vector(2), out_.vector(3)},
      made_{out_.vector(4), out_.vector(5)};
  const Vec t_ = out_.vector(6), spare_ = out_.vector(7), wild_ = out_.vector(8);
  const VectorAssembler::Mask mask_ = out_.mask(9), other_ = out_.mask(10);
};

}  // namespace

std::unique_ptr<const CompiledTape> CompiledTape::compile(const Tape& tape, Makes what, std::size_t lanes,
                                                          const Runners& helpers) {
  VectorAssembler assembler(lanes);
  std::size_t vectors = 1;  // per slot
  switch (what) {
    case Makes::values: ValuesCode(assembler, tape, helpers).emit(); break;
    case Makes::gradients:
      vectors = 4;
      GradientsCode(assembler, tape, helpers).emit();
      break;
    default:
      if (!std::all_of(tape.constants.begin(), tape.constants.end(), [](float c) { return std::isfinite(c); }))
        return nullptr;
      vectors = 2;
      IntervalsCode(assembler, tape, helpers, what == Makes::sign_intervals).emit();
  }
  std::unique_ptr<CodeMemory> code = assembler.finish();
  if (!code) return nullptr;
  const std::size_t frame = VectorAssembler::frame_slots + tape.slots * vectors;
  return std::unique_ptr<const CompiledTape>(new CompiledTape(std::move(code), what, lanes, frame));
}

std::uint32_t CompiledTape::run(const IntervalRun& run, LaneRanges& root) const noexcept {
  std::fill_n(run.choices, run.clauses, Choice{0, 0});
  std::array<float, box_lanes> wild;
  VectorAssembler::Arguments arguments{
      {}, {root.lower, root.upper, wild.data()}, 0, scratch<float>(frame_floats_), run.choices};
  for (std::size_t axis = 0; axis < 3; ++axis)
    arguments.in[2 * axis] = run.box[axis].lower, arguments.in[2 * axis + 1] = run.box[axis].upper;
  const std::size_t lanes = (run.lanes + lanes_ - 1) / lanes_ * lanes_;
  arguments.bytes = lanes * sizeof(float);
  reinterpret_cast<VectorAssembler::Function>(code_->data())(&arguments);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < lanes; ++i)
    bits |= static_cast<std::uint32_t>(std::bit_cast<std::uint32_t>(wild[i]) > 0x7f7fffffU) << i;
  return bits;
}

void CompiledTape::run(const Points& points, const std::array<float*, 4>& out) const noexcept {
  const auto function = reinterpret_cast<VectorAssembler::Function>(code_->data());
  VectorAssembler::Arguments arguments{
      {points.x, points.y, points.z}, {out[0], out[1], out[2], out[3]}, 0, scratch<float>(frame_floats_), nullptr};
  const std::size_t whole = points.count / lanes_ * lanes_, rest = points.count - whole;
  arguments.bytes = whole * sizeof(float);
  function(&arguments);
  if (rest == 0) return;

  // The last points, which do not fill a vector, padded with copies of the last one.
  constexpr std::size_t most_lanes = 16;
  std::array<std::array<float, most_lanes>, 3> in;
  std::array<std::array<float, most_lanes>, 4> results;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* const from = arguments.in[axis] + whole;
    for (std::size_t i = 0; i < lanes_; ++i) in[axis][i] = from[std::min(i, rest - 1)];
    arguments.in[axis] = in[axis].data();
  }
  for (std::size_t i = 0; i < std::min(outs_, out.size()); ++i) arguments.out[i] = results[i].data();
  arguments.bytes = lanes_ * sizeof(float);
  function(&arguments);
  for (std::size_t i = 0; i < std::min(outs_, out.size()); ++i) std::copy_n(results[i].data(), rest, out[i] + whole);
}

}  // namespace fieldfab::frep
