// Patterns of corner signs that contain a single patch of surface.
#include <bit>

#include "octree.h"

namespace fieldfab::contouring {
namespace {

/// Returns the corners reachable from the lowest set corner along cube edges between set corners.
unsigned component(unsigned corners) {
  unsigned reached = corners & (~corners + 1);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (unsigned bit : {1U, 2U, 4U}) {
      unsigned step = 0;
      for (unsigned corner = 0; corner < 8; ++corner)
        if (reached >> corner & 1U) step |= 1U << (corner ^ bit);
      reached |= step & corners;
    }
  }
  return reached;
}

bool has_ambiguous_face(unsigned corners) {
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, base = side << axis;
      const auto inside = [&](unsigned corner) { return (corners >> corner & 1U) != 0; };
      if (inside(base) == inside(base | u | v) && inside(base | u) == inside(base | v) &&
          inside(base) != inside(base | u))
        return true;
    }
  return false;
}

std::array<bool, 256> find_simple() {
  std::array<bool, 256> simple{};
  for (unsigned corners = 1; corners < 255; ++corners)
    simple[corners] = component(corners) == corners && component(~corners & 255U) == (~corners & 255U) &&
                      !has_ambiguous_face(corners);
  return simple;
}

unsigned point_of_corner(unsigned corner) { return 2 * (corner & 1U) + 6 * (corner >> 1 & 1U) + 18 * (corner >> 2); }

/// For each of 3x3x3 lattice points: the corners, as points, of the edge, face or cube whose middle
/// it is. The point must have the sign of one of them; otherwise it shows something that the
/// corners hide.
std::array<unsigned, 27> find_corners_around() {
  std::array<unsigned, 27> around{};
  for (unsigned point = 0; point < 27; ++point)
    for (unsigned corner = 0; corner < 8; ++corner) {
      const std::array<unsigned, 3> at{point % 3, point / 3 % 3, point / 9};
      bool near = true;
      for (unsigned axis = 0; axis < 3; ++axis) near = near && (at[axis] == 1 || at[axis] == 2 * (corner >> axis & 1U));
      if (near) around[point] |= 1U << point_of_corner(corner);
    }
  return around;
}

bool differs_diagonally(bool a, bool b, bool c, bool d) { return a == d && b == c && a != b; }

std::array<bool, 512> find_plain_faces() {
  std::array<bool, 512> plain{};
  for (unsigned inside = 0; inside < 512; ++inside) {
    const auto at = [&](unsigned u, unsigned v) { return (inside >> (u + 3 * v) & 1U) != 0; };
    const auto between = [](bool middle, bool one, bool other) { return middle == one || middle == other; };
    bool good = between(at(1, 0), at(0, 0), at(2, 0)) && between(at(1, 2), at(0, 2), at(2, 2)) &&
                between(at(0, 1), at(0, 0), at(0, 2)) && between(at(2, 1), at(2, 0), at(2, 2));
    good = good && (between(at(1, 1), at(0, 0), at(2, 0)) || between(at(1, 1), at(0, 2), at(2, 2)));
    good = good && !differs_diagonally(at(0, 0), at(2, 0), at(0, 2), at(2, 2));
    for (unsigned u = 0; u < 2; ++u)
      for (unsigned v = 0; v < 2; ++v)
        good = good && !differs_diagonally(at(u, v), at(u + 1, v), at(u, v + 1), at(u + 1, v + 1));
    plain[inside] = good;
  }
  return plain;
}

}  // namespace

std::uint8_t Division::corners(unsigned child) const {
  const unsigned first = (child & 1U) + 3 * (child >> 1 & 1U) + 9 * (child >> 2);
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
    bits |= (inside >> (first + (corner & 1U) + 3 * (corner >> 1 & 1U) + 9 * (corner >> 2)) & 1U) << corner;
  return static_cast<std::uint8_t>(bits);
}

bool is_plain_face(unsigned inside) {
  static const std::array<bool, 512> table = find_plain_faces();
  return table[inside];
}

bool is_simple(std::uint8_t corners) {
  static const std::array<bool, 256> table = find_simple();
  return table[corners];
}

bool merge_corners(const std::array<std::uint8_t, 8>& children, std::uint8_t& merged) {
  unsigned inside = 0;  // one bit per lattice point of the 3x3x3 points of the eight cells, x fastest
  for (unsigned child = 0; child < 8; ++child) {
    const unsigned c = children[child], low = (c & 3U) | (c & 12U) << 1, high = (c >> 4 & 3U) | (c >> 4 & 12U) << 1;
    inside |= (low | high << 9) << ((child & 1U) + 3 * (child >> 1 & 1U) + 9 * (child >> 2));
  }
  unsigned corners = 0;
  for (unsigned corner = 0; corner < 8; ++corner) corners |= (inside >> point_of_corner(corner) & 1U) << corner;
  merged = static_cast<std::uint8_t>(corners);
  if (!is_simple(merged)) return false;
  static const std::array<unsigned, 27> around = find_corners_around();
  for (unsigned point = 0; point < 27; ++point)
    if (((inside >> point & 1U) != 0 ? inside & around[point] : ~inside & around[point]) == 0) return false;
  return true;
}

}  // namespace fieldfab::contouring
