#include "seams.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fieldfab/core/geometry.h"

namespace fieldfab::frep {
namespace {

/// The value of an operand of the tape, or its negative, plus a shift.
struct Term {
  Operand operand = 0;
  bool negative = false;
  double shift = 0;
};

/// An affine value: normal * p + offset.
struct Affine {
  Vec3 normal = Vec3::Zero();
  double offset = 0;
  double greatest = 0;  ///< magnitude of the numbers that were added to the offset: how exact it is
};

/// The half-space in which a term is negative; the normal has unit length.
struct HalfSpace : Affine {
  Term term;
};

/// What is known of the points that matter: they are in a half-space, or (up to its face) outside.
struct Known {
  HalfSpace plane;
  bool inside;
};

/// How a term is negative: never, always, as other terms are, or in a way of its own.
struct Reading {
  enum class Kind { nothing, everything, same, intersection, union_of_terms, other } kind = Kind::other;
  Term first = {}, second = {};
};

/// A part of the solid.
struct Part {
  enum class Kind { nothing, everything, term, intersection, union_of_parts } kind = Kind::nothing;
  Term term = {};
  std::size_t first = 0, second = 0;   ///< of two parts, by number
  std::vector<HalfSpace> planes = {};  ///< the half-space that the term is, or those among the parts

  [[nodiscard]] bool settled() const { return kind == Kind::nothing || kind == Kind::everything; }
};

/// Reads a tape as intersections and unions of half-spaces and of what is no half-space.
class SeamMerger {
 public:
  explicit SeamMerger(const Tape& tape)
      : tape_(tape), affine_(first_value + tape.code.size()), copies_(affine_.size()) {
    for (Operand axis = 0; axis < first_value; ++axis) affine_[axis] = Affine{Vec3::Unit(axis)};
    for (std::size_t i = 0; i < tape.code.size(); ++i) affine_[first_value + i] = affine(tape.code[i]);
  }

  bool run(Tape& merged) {
    const Part whole = simplified({tape_.root});
    if (!simpler_ || visits_ > most_visits) return false;
    merged.code.clear();
    merged.root = whole.settled() ? constant(whole.kind == Part::Kind::nothing ? 1 : -1) : emitted(whole, merged.code);
    merged.constants = tape_.constants;
    merged.constants.insert(merged.constants.end(), more_constants_.begin(), more_constants_.end());
    choose_slots(merged);
    return true;
  }

 private:
  static constexpr int most_visits = 500;
  static constexpr double parallel = 1e-6;
  static constexpr double rounding = 3e-7;  // of some operations in single precision, one after another

  /// How far apart two planes may seem to be that are one.
  static double tolerance(const HalfSpace& one, const HalfSpace& other) {
    return rounding * std::max(one.greatest, other.greatest);
  }

  static Affine constant_affine(double value) { return {Vec3::Zero(), value, std::abs(value)}; }

  [[nodiscard]] std::optional<Affine> affine(Operand operand) const {
    return is_constant(operand) ? constant_affine(tape_.constants[operand & ~constant_bit]) : affine_[operand];
  }

  [[nodiscard]] std::optional<Affine> affine(const Clause& clause) const {
    const std::optional<Affine> a = affine(clause.a), b = affine(clause.b);
    if (!a || !b) return {};
    const bool constants = a->normal.isZero(0) && b->normal.isZero(0);
    if (constants) return constant_affine(apply(clause.op, a->offset, b->offset));
    const auto scaled = [](const Affine& value, double factor) {
      return Affine{value.normal * factor, value.offset * factor, value.greatest * std::abs(factor)};
    };
    const double greatest = std::max(a->greatest, b->greatest);
    switch (clause.op) {
      case Opcode::add: return Affine{a->normal + b->normal, a->offset + b->offset, greatest};
      case Opcode::subtract: return Affine{a->normal - b->normal, a->offset - b->offset, greatest};
      case Opcode::negate: return scaled(*a, -1);
      case Opcode::multiply:
        if (a->normal.isZero(0)) return scaled(*b, a->offset);
        if (b->normal.isZero(0)) return scaled(*a, b->offset);
        return {};
      case Opcode::divide:
        if (b->normal.isZero(0) && b->offset != 0) return scaled(*a, 1 / b->offset);
        return {};
      default: return {};
    }
  }

  [[nodiscard]] std::optional<double> constant_value(Operand operand) const {
    const std::optional<Affine> value = affine(operand);
    return value && value->normal.isZero(0) ? std::optional(value->offset) : std::nullopt;
  }

  [[nodiscard]] std::optional<HalfSpace> half_space(const Term& term) const {
    const std::optional<Affine> value = affine(term.operand);
    if (!value) return {};
    const double sign = term.negative ? -1 : 1, length = value->normal.norm();
    if (!std::isfinite(1 / length)) return {};
    return HalfSpace{{sign / length * value->normal, (sign * value->offset + term.shift) / length,
                      std::max(value->greatest, std::abs(term.shift)) / length},
                     term};
  }

  /// Whether an operand is never negative, as far as its last operations tell.
  [[nodiscard]] bool is_positive(Operand operand, int depth = 0) const {
    if (const std::optional<double> value = constant_value(operand)) return *value >= 0;
    if (!is_made(operand) || depth > 3) return false;
    const Clause& clause = tape_.code[operand - first_value];
    if (clause.op == Opcode::add) return is_positive(clause.a, depth + 1) && is_positive(clause.b, depth + 1);
    return clause.op == Opcode::square || clause.op == Opcode::absolute || clause.op == Opcode::square_root;
  }

  /// Where |value| < -shift, or, of the negative, where |value| > shift.
  static Reading magnitude(Operand value, const Term& term, double shift) {
    if (!term.negative && term.shift >= 0) return {Reading::Kind::nothing};
    if (term.negative && term.shift < 0) return {Reading::Kind::everything};
    return {term.negative ? Reading::Kind::union_of_terms : Reading::Kind::intersection,
            {value, false, shift},
            {value, true, shift}};
  }

  [[nodiscard]] Reading read(const Term& term) const {
    using enum Reading::Kind;
    if (!is_made(term.operand)) return {};
    const Clause& clause = tape_.code[term.operand - first_value];
    const double sign = term.negative ? -1 : 1;
    const std::optional<double> a = constant_value(clause.a), b = constant_value(clause.b);
    switch (clause.op) {
      case Opcode::negate: return {same, {clause.a, !term.negative, term.shift}};
      case Opcode::add:
        if (a) return {same, {clause.b, term.negative, term.shift + sign * *a}};
        if (b) return {same, {clause.a, term.negative, term.shift + sign * *b}};
        return {};
      case Opcode::subtract:
        if (a) return {same, {clause.b, !term.negative, term.shift + sign * *a}};
        if (b) return {same, {clause.a, term.negative, term.shift - sign * *b}};
        return {};
      case Opcode::multiply:
        if (a && *a != 0) return {same, {clause.b, term.negative != (*a < 0), term.shift / std::abs(*a)}};
        if (b && *b != 0) return {same, {clause.a, term.negative != (*b < 0), term.shift / std::abs(*b)}};
        return {};
      case Opcode::divide:
        if (b && *b != 0) return {same, {clause.a, term.negative != (*b < 0), term.shift * std::abs(*b)}};
        return {};
      case Opcode::minimum:
      case Opcode::maximum:
        return {(clause.op == Opcode::maximum) != term.negative ? intersection : union_of_terms,
                {clause.a, term.negative, term.shift},
                {clause.b, term.negative, term.shift}};
      case Opcode::absolute: return magnitude(clause.a, term, term.shift);
      case Opcode::square: return magnitude(clause.a, term, sign * std::sqrt(std::abs(term.shift)) * -1);
      case Opcode::square_root:
        if (!is_positive(clause.a)) return {};
        if (!term.negative && term.shift >= 0) return {nothing};
        if (term.negative && term.shift < 0) return {everything};
        return {same, {clause.a, term.negative, -sign * term.shift * term.shift}};
      default: return {};
    }
  }

  /// What is known within an intersection with a term, or outside a union with it.
  void assume(const Term& term, bool intersection) {
    if (++visits_ > most_visits) return;
    if (const std::optional<HalfSpace> plane = half_space(term)) return known_.push_back({*plane, intersection});
    const Reading reading = read(term);
    if (reading.kind == Reading::Kind::same) return assume(reading.first, intersection);
    if (reading.kind != (intersection ? Reading::Kind::intersection : Reading::Kind::union_of_terms)) return;
    assume(reading.first, intersection);
    assume(reading.second, intersection);
  }

  void assume(const Part& part, bool intersection) {
    if (part.kind == Part::Kind::term || part.kind == joined_kind(intersection))
      for (const HalfSpace& plane : part.planes) known_.push_back({plane, intersection});
  }
  static Part::Kind joined_kind(bool intersection) {
    return intersection ? Part::Kind::intersection : Part::Kind::union_of_parts;
  }

  /// Whether what is known tells that a half-space holds all points that matter, or none; up to rounding.
  [[nodiscard]] std::optional<bool> told(const HalfSpace& plane) const {
    for (const Known& known : known_) {
      const double inner = known.plane.offset, outer = plane.offset, near = tolerance(known.plane, plane);
      if ((known.plane.normal - plane.normal).norm() < parallel) {
        if (known.inside && outer <= inner + near) return true;
        if (!known.inside && outer >= inner - near) return false;
      } else if ((known.plane.normal + plane.normal).norm() < parallel) {
        if (known.inside && outer >= -inner - near) return false;
        if (!known.inside && outer <= -inner + near) return true;
      }
    }
    return {};
  }

  /// The part of the solid that a term is among the points that matter.
  Part simplified(const Term& term) {
    if (++visits_ > most_visits) return {};
    if (const std::optional<HalfSpace> plane = half_space(term)) {
      const std::optional<bool> inside = told(*plane);
      if (!inside) return part_of(*plane);
      simpler_ = true;
      return {*inside ? Part::Kind::everything : Part::Kind::nothing};
    }
    const Reading reading = read(term);
    switch (reading.kind) {
      case Reading::Kind::nothing: return {Part::Kind::nothing};
      case Reading::Kind::everything: return {Part::Kind::everything};
      case Reading::Kind::same: return simplified(reading.first);
      case Reading::Kind::other: return {Part::Kind::term, term};
      case Reading::Kind::intersection:
      case Reading::Kind::union_of_terms: break;
    }
    const bool intersection = reading.kind == Reading::Kind::intersection;
    const std::size_t before = known_.size();
    if (const std::optional<HalfSpace> common = common_plane(reading, !intersection)) {
      simpler_ = true;
      known_.push_back({*common, !intersection});
      Part rest = simplified(term);
      known_.resize(before);
      return joined(part_of(*common), std::move(rest), !intersection);
    }
    assume(reading.second, intersection);
    Part first = simplified(reading.first);
    known_.resize(before);
    assume(first, intersection);
    Part second = simplified(reading.second);
    known_.resize(before);
    return joined(std::move(first), std::move(second), intersection);
  }

  static Part part_of(const HalfSpace& plane) { return {Part::Kind::term, plane.term, 0, 0, {plane}}; }

  /// A half-space that both terms are intersections with, or unions with: it can be taken out.
  std::optional<HalfSpace> common_plane(const Reading& reading, bool intersection) {
    const std::size_t before = known_.size();
    assume(reading.first, intersection);
    const std::size_t between = known_.size();
    assume(reading.second, intersection);
    std::optional<HalfSpace> common;
    for (std::size_t i = before; i < between && !common; ++i)
      for (std::size_t j = between; j < known_.size() && !common; ++j)
        if ((known_[i].plane.normal - known_[j].plane.normal).norm() < parallel &&
            std::abs(known_[i].plane.offset - known_[j].plane.offset) <= tolerance(known_[i].plane, known_[j].plane))
          common = known_[i].plane;
    known_.resize(before);
    return common && !told(*common) ? common : std::nullopt;
  }

  Part joined(Part first, Part second, bool intersection) {
    const Part::Kind decisive = intersection ? Part::Kind::nothing : Part::Kind::everything;
    if (first.kind == decisive || second.kind == decisive) return {decisive};
    if (first.settled()) return second;
    if (second.settled()) return first;
    Part both{joined_kind(intersection)};
    for (const Part* part : {&first, &second})
      if (part->kind == Part::Kind::term || part->kind == both.kind)
        both.planes.insert(both.planes.end(), part->planes.begin(), part->planes.end());
    both.first = parts_.size(), both.second = parts_.size() + 1;
    parts_.push_back(std::move(first));
    parts_.push_back(std::move(second));
    return both;
  }

  Operand constant(double value) {
    more_constants_.push_back(static_cast<float>(value));
    return static_cast<Operand>(tape_.constants.size() + more_constants_.size() - 1) | constant_bit;
  }

  Operand emitted(const Part& part, std::vector<Clause>& code) {
    const auto emit = [&](Opcode op, Operand a, Operand b) {
      code.push_back({op, true, 0, a, b});
      return first_value + static_cast<Operand>(code.size() - 1);
    };
    if (part.kind == Part::Kind::term) {
      Operand made = copied(part.term.operand, code);
      if (part.term.negative) made = emit(Opcode::negate, made, made);
      if (part.term.shift != 0) made = emit(Opcode::add, made, constant(part.term.shift));
      return made;
    }
    const Operand first = emitted(parts_[part.first], code), second = emitted(parts_[part.second], code);
    return emit(part.kind == Part::Kind::intersection ? Opcode::maximum : Opcode::minimum, first, second);
  }

  Operand copied(Operand operand, std::vector<Clause>& code) {
    if (!is_made(operand)) return operand;
    std::optional<Operand>& copy = copies_[operand];
    if (!copy) {
      Clause made = tape_.code[operand - first_value];
      made.a = copied(made.a, code), made.b = copied(made.b, code);
      made.only_sign_matters = false;
      code.push_back(made);
      copy = first_value + static_cast<Operand>(code.size() - 1);
    }
    return *copy;
  }

  const Tape& tape_;
  std::vector<std::optional<Affine>> affine_;   // by operand of the tape
  std::vector<std::optional<Operand>> copies_;  // by operand of the tape
  std::vector<float> more_constants_;           // than the tape has
  std::vector<Known> known_;
  std::vector<Part> parts_;
  bool simpler_ = false;
  int visits_ = 0;
};

}  // namespace

bool merge_seams(const Tape& tape, Tape& merged) {
  const auto joins = std::count_if(tape.code.begin(), tape.code.end(), [](const Clause& clause) {
    return clause.op == Opcode::minimum || clause.op == Opcode::maximum;
  });
  return joins > 0 && tape.code.size() <= most_clauses_with_seams && SeamMerger(tape).run(merged);
}

}  // namespace fieldfab::frep
