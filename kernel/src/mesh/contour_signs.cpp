// Which patterns of corner signs hold a single patch of surface.
#include <bit>

#include "contour_octree.h"

namespace fieldfab::contouring {
namespace {

/// The corners reachable from the lowest set corner along cube edges between set corners.
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
      if (inside(base) == inside(base | u | v) && inside(base | u) == inside(base | v) && inside(base) != inside(base | u))
        return true;
    }
  return false;
}

std::array<bool, 256> find_simple() {
  std::array<bool, 256> simple{};
  for (unsigned corners = 1; corners < 255; ++corners)
    simple[corners] =
        component(corners) == corners && component(~corners & 255U) == (~corners & 255U) && !has_ambiguous_face(corners);
  return simple;
}

}  // namespace

bool is_simple(std::uint8_t corners) {
  static const std::array<bool, 256> table = find_simple();
  return table[corners];
}

bool merge_corners(const std::array<std::uint8_t, 8>& children, std::uint8_t& merged) {
  std::array<bool, 27> inside{};  // the 3x3x3 lattice points of the eight cells, x fastest
  for (unsigned child = 0; child < 8; ++child)
    for (unsigned corner = 0; corner < 8; ++corner) {
      const unsigned x = (child & 1U) + (corner & 1U), y = (child >> 1 & 1U) + (corner >> 1 & 1U),
                     z = (child >> 2) + (corner >> 2);
      inside[x + 3 * y + 9 * z] = (children[child] >> corner & 1U) != 0;
    }
  unsigned corners = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
    if (inside[2 * (corner & 1U) + 6 * (corner >> 1 & 1U) + 18 * (corner >> 2)]) corners |= 1U << corner;
  merged = static_cast<std::uint8_t>(corners);
  if (!is_simple(merged)) return false;

  // The middle of each edge, face and of the cell must agree with one of the corners around it: otherwise something is hidden
  // there.
  for (unsigned z = 0; z < 3; ++z)
    for (unsigned y = 0; y < 3; ++y)
      for (unsigned x = 0; x < 3; ++x) {
        bool agrees = false;
        for (unsigned corner = 0; corner < 8 && !agrees; ++corner) {
          const unsigned cx = 2 * (corner & 1U), cy = 2 * (corner >> 1 & 1U), cz = 2 * (corner >> 2);
          if ((x != 1 && x != cx) || (y != 1 && y != cy) || (z != 1 && z != cz)) continue;
          agrees = inside[x + 3 * y + 9 * z] == inside[cx + 3 * cy + 9 * cz];
        }
        if (!agrees) return false;
      }
  return true;
}

}  // namespace fieldfab::contouring
