/// An expression as straight-line code: what is evaluated over intervals, pruned, and run in batches (Keeter 3.6 to 3.8).
#pragma once

#include <cstdint>
#include <vector>

#include "clause.h"
#include "fieldfab/core/interval.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Straight-line code in which each value is made once, after its arguments, and each serves the root.
struct Tape {
  std::vector<Clause> code;
  std::vector<float> constants;
  Operand root = 0;
  /// The slot that holds each clause's value while a batch is evaluated: slots are reused, so that a batch stays in the cache.
  std::vector<std::uint32_t> slot;
  std::uint32_t slots = 0;  ///< how many there are
};

Tape make_tape(const Expression& expression);

/// The intervals of all values of a tape over a box, by operand. Kept as three arrays: a processor waits long for a structure
/// that was written in parts and is read as one.
struct Ranges {
  std::vector<float> lower, upper;
  std::vector<std::uint8_t> maybe_nan;

  void resize(std::size_t count) { lower.resize(count), upper.resize(count), maybe_nan.resize(count); }
  void set(std::size_t i, const Interval& range) {
    lower[i] = range.lower, upper[i] = range.upper, maybe_nan[i] = static_cast<std::uint8_t>(range.maybe_nan);
  }
  [[nodiscard]] Interval operator[](std::size_t i) const { return {lower[i], upper[i], maybe_nan[i] != 0}; }
};

/// The intervals of all values over a box: `ranges` gets first_value + code.size() entries. Returns the root's.
Interval evaluate_ranges(const Tape& tape, const Interval& x, const Interval& y, const Interval& z, Ranges& ranges);

/// Whether the tape only adds, subtracts, negates, and multiplies with and divides by constants.
bool is_affine(const Tape& tape);

/// The code that still matters where the values are known to be in `ranges` (Algs 3.3 and 3.4). False, and `pruned` untouched,
/// where that is all of it.
bool prune(const Tape& tape, const Ranges& ranges, Purpose purpose, Tape& pruned);

}  // namespace fieldfab::frep
