/// The intervals of a tape over one box, precisely: with infinities, and with what may be NaN.
#pragma once

#include <cstdint>
#include <vector>

#include "batch.h"
#include "fieldfab/core/interval.h"
#include "fieldfab/field/field.h"
#include "tape.h"

namespace fieldfab::frep {

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

/// Sets bit `lane` of the choices that these ranges allow (see Choice) and clears it where they allow none.
void record_choices(const Tape& tape, const Ranges& ranges, Purpose purpose, unsigned lane, Choice* choices);

}  // namespace fieldfab::frep
