/// Good-bad maps, the split planes that follow from them (Hahn 3.1, 3.2, 5.3), and the rules that
/// choose one (3.3, 6.2).
#pragma once

#include <random>
#include <string>
#include <vector>

#include "cell.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// Intersection of a line along the map's axis with the solid.
enum class Pixel : std::uint8_t {
  none,      ///< no surface: all solid or all air
  positive,  ///< solid from the lower end to a surface that faces upwards
  negative,  ///< solid from a surface that faces downwards to the upper end
  segment,   ///< one solid run between two surfaces: bad in the thesis, good for columns with both ends
  bad,       ///< more than one solid run
};

/// A map of the lines along an axis; u and v are the other axes in cyclic order, u fastest.
struct GoodBadMap {
  int axis = 0, u0 = 0, v0 = 0, width = 0, height = 0;
  std::vector<Pixel> pixels;
  std::vector<char> unresolved;  ///< the line meets surface that the cell's own direction cannot
                                 ///< represent
  std::vector<char> tool;        ///< the line meets the tool

  [[nodiscard]] std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v - v0) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u - u0);
  }
};

GoodBadMap good_bad_map(const Occupancy& solid, int axis);
/// Whether columns along the map's axis can represent the surface; sets `facing` as in Cell.
/// Without `both_ends`, segments are not permitted, nor pixels of both signs.
bool functional(const GoodBadMap& map, bool both_ends, std::int8_t& facing);

/// A family of split planes: the upper child begins at a point from `first` to `last` along `axis`.
struct SplitInterval {
  enum class Kind : std::uint8_t { conflict, indirect, direct };
  Kind kind = Kind::direct;
  int axis = 0, first = 0, last = 0;
  bool complete = false;  ///< separates completely (conflict and indirect planes)
  bool sole = false;      ///< the only interval of its series (direct planes)
};

/// Split planes for a cell with the points `solid`, of which the tool has `covered` some, and with
/// former columns along `axis` with `facing`.
std::vector<SplitInterval> split_intervals(const Occupancy& solid, const Occupancy& covered, int axis,
                                           std::int8_t facing, bool both_ends);

/// A choice by the rules in their order. Within an interval it is the plane nearest to the cell's
/// middle.
struct SplitChoice {
  int axis = 0, plane = 0;
  SplitInterval::Kind kind = SplitInterval::Kind::direct;
};
SplitChoice choose_split(const std::vector<SplitInterval>& intervals, const Region& region, const Vec3& spacing,
                         const std::vector<SplitRule>& rules, const Vec3& tool_axis, double tool_radius,
                         std::minstd_rand& random);

}  // namespace fieldfab::cam
