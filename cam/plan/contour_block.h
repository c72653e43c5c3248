/// Squares of a lattice over a region, and the contour's segments in one block of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fieldfab/cam/plan/contour.h"

namespace fieldfab::cam {

constexpr int block_side = 16;  // squares along a side of a block, which are sampled individually

/// A lattice edge that the contour crosses: its first sample, and whether it is parallel to y.
using Crossing = std::uint64_t;

/// Segment of a contour through one square, from one lattice edge to another, with the inside on its left.
struct Piece {
  Crossing from, to;
  std::array<float, 2> start, corner;  // corner: NaN if there is none
};

/// Samples of a lattice over a region; the outermost samples lie outside of the region.
struct Squares {
  Vec2 origin;
  double cell, z;
  int columns, rows;  // number of squares
  Rectangle region;
  [[nodiscard]] float x(int i) const { return static_cast<float>(origin.x() + cell * i); }
  [[nodiscard]] float y(int j) const { return static_cast<float>(origin.y() + cell * j); }
  [[nodiscard]] Crossing edge(int i, int j, int along_y) const {
    return (static_cast<Crossing>(j) * static_cast<Crossing>(columns + 2) + static_cast<Crossing>(i)) * 2 +
           static_cast<Crossing>(along_y);
  }
};

/// Squares [left, right) x [low, high).
struct Part {
  int left, low, right, high;
};

/// Samples at most block_side x block_side squares and appends the contour's segments in them. `missed`: receives parts
/// that the samples do not show, unless nullptr.
void trace_block(const Field& field, const Squares& squares, double level, const Part& part, std::vector<Piece>& pieces,
                 MissedParts* missed);

}  // namespace fieldfab::cam
