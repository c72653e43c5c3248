/// Exact intervals of a tape over one box, with infinities and NaN.
#pragma once

#include <cstdint>
#include <vector>

#include "batch.h"
#include "fieldfab/core/interval.h"
#include "fieldfab/field/field.h"
#include "tape.h"

namespace fieldfab::frep {

/// Intervals of all values of a tape over a box, by operand. Three arrays, since a processor stalls
/// if a structure is written in parts and read as a whole.
struct Ranges {
  std::vector<float> lower, upper;
  std::vector<std::uint8_t> maybe_nan;

  void resize(std::size_t count) { lower.resize(count), upper.resize(count), maybe_nan.resize(count); }
  void set(std::size_t i, const Interval& range) {
    lower[i] = range.lower, upper[i] = range.upper, maybe_nan[i] = static_cast<std::uint8_t>(range.maybe_nan);
  }
  [[nodiscard]] Interval operator[](std::size_t i) const { return {lower[i], upper[i], maybe_nan[i] != 0}; }
};

/// Computes the intervals of all values over a box: `ranges` gets first_value + code.size()
/// entries. Returns that of the root.
Interval evaluate_ranges(const Tape& tape, const Interval& x, const Interval& y, const Interval& z, Ranges& ranges);

/// Sets bit `lane` of the choices that these ranges allow (see Choice), and clears it otherwise.
void record_choices(const Tape& tape, const Ranges& ranges, Purpose purpose, unsigned lane, Choice* choices);

}  // namespace fieldfab::frep
