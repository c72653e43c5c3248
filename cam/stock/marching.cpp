#include "marching.h"

#include <functional>

namespace fieldfab::cam {
namespace {

int corner_of(int x, int y, int z) { return x + 2 * y + 4 * z; }

/// Number of the edge between two neighbouring corners.
int edge_between(int a, int b) {
  const int low = a & b, axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  const auto bit = [&](int which) { return low >> which & 1; };
  return 4 * axis + bit((axis + 1) % 3) + 2 * bit((axis + 2) % 3);
}

/// Corners of the six faces, anticlockwise seen from outside.
std::array<std::array<int, 4>, 6> faces() {
  std::array<std::array<int, 4>, 6> result{};
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 4; ++i) {
        const int turn = side ? i : 3 - i;
        std::array<int, 3> at{};
        at[static_cast<std::size_t>(axis)] = side;
        at[static_cast<std::size_t>((axis + 1) % 3)] = turn == 1 || turn == 2;
        at[static_cast<std::size_t>((axis + 2) % 3)] = turn >= 2;
        result[static_cast<std::size_t>(2 * axis + side)][static_cast<std::size_t>(i)] = corner_of(at[0], at[1], at[2]);
      }
  return result;
}

/// Whether two edges lie on one face of the cube.
bool on_one_face(int one, int other) {
  for (const auto& face : faces()) {
    bool has_one = false, has_other = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const int edge = edge_between(face[i], face[(i + 1) % 4]);
      has_one |= edge == one, has_other |= edge == other;
    }
    if (has_one && has_other) return true;
  }
  return false;
}

/// Triangulates a loop such that no inner edge lies in a face. Returns false if that is impossible.
bool divide(const std::vector<std::int8_t>& loop, std::vector<std::array<std::int8_t, 3>>& triangles) {
  if (loop.size() == 3) {
    triangles.push_back({loop[0], loop[1], loop[2]});
    return true;
  }
  const std::size_t n = loop.size(), before = triangles.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::int8_t last = loop[(i + n - 1) % n], next = loop[(i + 1) % n];
    if (on_one_face(last, next)) continue;
    std::vector<std::int8_t> rest = loop;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    triangles.push_back({last, loop[i], next});
    if (divide(rest, triangles)) return true;
    triangles.resize(before);
  }
  return false;
}

CubeCase make_case(int solid) {
  std::array<int, 12> next;
  next.fill(-1);
  for (const auto& face : faces())
    for (std::size_t i = 0; i < 4; ++i) {
      // For a run of solid corners that begins at corner i, the surface leads from the end of the
      // run to its start.
      const auto is_solid = [&](std::size_t k) { return solid >> face[k % 4] & 1; };
      if (!is_solid(i) || is_solid(i + 3)) continue;
      std::size_t end = i;
      while (is_solid(end + 1)) ++end;
      const int enter = edge_between(face[(i + 3) % 4], face[i]),
                exit = edge_between(face[end % 4], face[(end + 1) % 4]);
      next[static_cast<std::size_t>(enter)] = exit;
    }
  CubeCase result;
  std::array<bool, 12> used{};
  for (int start = 0; start < 12; ++start) {
    if (next[static_cast<std::size_t>(start)] < 0 || used[static_cast<std::size_t>(start)]) continue;
    std::vector<std::int8_t> loop;
    for (int edge = start; !used[static_cast<std::size_t>(edge)]; edge = next[static_cast<std::size_t>(edge)]) {
      used[static_cast<std::size_t>(edge)] = true;
      loop.push_back(static_cast<std::int8_t>(edge));
    }
    if (divide(loop, result.triangles)) continue;
    const auto middle = static_cast<std::int8_t>(12 + result.middles.size());
    for (std::size_t i = 0; i < loop.size(); ++i)
      result.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
    result.middles.push_back(loop);
  }
  return result;
}

}  // namespace

const std::array<CubeCase, 256>& cube_cases() {
  static const std::array<CubeCase, 256> cases = [] {
    std::array<CubeCase, 256> made;
    for (int solid = 1; solid < 255; ++solid) made[static_cast<std::size_t>(solid)] = make_case(solid);
    return made;
  }();
  return cases;
}

}  // namespace fieldfab::cam
