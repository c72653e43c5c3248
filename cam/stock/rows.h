/// Rows of columns and intervals, compared many at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace fieldfab::cam {

/// Flags the lines whose interval from `entry` to `exit` begins below a column's top; `tops` null: all columns are solid. Whether
/// there are any. `flags` has room for 8 more than `count`.
bool flag_contacts(const float* entry, const float* exit, const float* tops, int count, std::uint8_t* flags);
/// Flags the lines that hold a point not above the last one of a neighbour's column: `before` and `after` are the rows of these
/// numbers next to `here`, each of which has one in front of the first and one behind the last line. Points lie 1 / `inverse`
/// apart; where rounding might matter there are flags too many.
bool flag_neighbours(const float* entry, const float* exit, const float* before, const float* here, const float* after, int count,
                     float inverse, std::uint8_t* flags);

/// The last points below the tops of columns, as numbers, but none above `last`; null: all columns are solid. Points lie
/// `spacing` apart, as StockLattice::at() has them.
void load_tops(const float* tops, int count, double spacing, float last, float* points);

/// Calls with the index of each flag that is set.
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
