#include "jumps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fieldfab::frep {
namespace {

bool jumps(const Clause& clause) {
  return clause.op == Opcode::modulo || clause.op == Opcode::floor || clause.op == Opcode::ceiling;
}

/// The steps of a modulo or a floor whose argument is an affine function of one coordinate.
class Steps {
 public:
  Steps(const Tape& tape, const Clause& clause) : tape_(tape), clause_(clause) {
    const bool periodic = clause.op == Opcode::modulo;
    if (!periodic || is_constant(clause.b)) axis_ = axis_of(clause.a);
  }

  /// The coordinate's axis, if there is one.
  [[nodiscard]] std::optional<Operand> axis() const { return axis_; }

  /// The number of the step at a coordinate.
  [[nodiscard]] float step(float coordinate) const {
    const float argument = value(clause_.a, coordinate);
    if (clause_.op != Opcode::modulo) return apply(clause_.op, argument);
    return apply(Opcode::floor, apply(Opcode::divide, argument, value(clause_.b, 0)));
  }

 private:
  [[nodiscard]] std::optional<Operand> axis_of(Operand operand) const {
    if (is_constant(operand)) return {};
    if (!is_made(operand)) return operand;
    const Clause& clause = tape_.code[operand - first_value];
    switch (clause.op) {
      case Opcode::negate: return axis_of(clause.a);
      case Opcode::divide: return is_constant(clause.b) ? axis_of(clause.a) : std::nullopt;
      case Opcode::add:
      case Opcode::subtract:
      case Opcode::multiply:
        if (is_constant(clause.a)) return axis_of(clause.b);
        if (is_constant(clause.b)) return axis_of(clause.a);
        return {};
      default: return {};
    }
  }

  [[nodiscard]] float value(Operand operand, float coordinate) const {
    if (is_constant(operand)) return tape_.constants[operand & ~constant_bit];
    if (!is_made(operand)) return coordinate;
    const Clause& clause = tape_.code[operand - first_value];
    return apply(clause.op, value(clause.a, coordinate), value(clause.b, coordinate));
  }

  const Tape& tape_;
  const Clause& clause_;
  std::optional<Operand> axis_;
};

/// The last float before the only jump between two coordinates; nothing if there is none, or more than one.
std::optional<float> last_before_jump(const Steps& steps, float lower, float upper) {
  const float first = steps.step(lower), last = steps.step(upper);
  if (!(std::abs(last - first) == 1)) return {};
  while (true) {
    const float middle = lower + (upper - lower) / 2;
    if (!(middle > lower && middle < upper)) return lower;
    (steps.step(middle) == first ? lower : upper) = middle;
  }
}

}  // namespace

bool has_jumps(const Tape& tape) { return std::any_of(tape.code.begin(), tape.code.end(), jumps); }

std::size_t divide_at_jumps(const Tape& tape, const Box& box, std::array<Box, most_pieces>& pieces) {
  std::size_t count = 1;
  pieces[0] = box;
  for (const Clause& clause : tape.code) {
    if (!jumps(clause)) continue;
    const Steps steps(tape, clause);
    if (!steps.axis()) continue;
    const auto axis = static_cast<Eigen::Index>(*steps.axis());
    for (std::size_t i = 0, before = count; i < before; ++i) {
      const std::optional<float> last =
          last_before_jump(steps, static_cast<float>(pieces[i].lower[axis]), static_cast<float>(pieces[i].upper[axis]));
      if (!last) continue;
      if (count == most_pieces) return 1;
      pieces[count] = pieces[i];
      pieces[i].upper[axis] = *last;
      pieces[count++].lower[axis] = std::nextafter(*last, std::numeric_limits<float>::infinity());
    }
  }
  return count;
}

}  // namespace fieldfab::frep
