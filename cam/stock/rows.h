/// Comparisons of rows of columns and intervals, vectorized.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace fieldfab::cam {

/// Flags the lines whose interval [entry, exit] begins below the top of the column. `tops` null:
/// all columns are solid. Returns whether a flag is set. `flags` needs room for count + 8 elements.
bool flag_contacts(const float* entry, const float* exit, const float* tops, int count, std::uint8_t* flags);
/// Flags the lines whose interval contains a point that is not above the last point of a
/// neighbouring column. `before` and `after` are the neighbours of the row `here`; each has one
/// more element at both ends. The spacing of points is 1 / `inverse`. There are false positives
/// within the rounding error.
bool flag_neighbours(const float* entry, const float* exit, const float* before, const float* here, const float* after,
                     int count, float inverse, std::uint8_t* flags);

/// Computes the last point below the top of each column, as a number, at most `last`. `tops` null:
/// all columns are solid. Points have the distance `spacing`, as in StockLattice::at().
void load_tops(const float* tops, int count, double spacing, float last, float* points);

/// Calls body(index) for each set flag.
template <class Body>
void for_each_flag(const std::uint8_t* flags, int count, const Body& body) {
  for (int i = 0; i < count; i += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, flags + i, 8);
    for (; eight; eight &= ~(std::uint64_t{0xFF} << (std::countr_zero(eight) / 8 * 8))) {
      const int at = i + std::countr_zero(eight) / 8;
      if (at >= count) return;
      body(at);
    }
  }
}

}  // namespace fieldfab::cam
