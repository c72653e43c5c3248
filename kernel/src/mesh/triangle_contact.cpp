#include "fieldfab/mesh/triangle_contact.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>

#include <algorithm>

namespace fieldfab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point_of(std::span<const std::array<float, 3>> vertices, std::uint32_t vertex) {
  const auto& p = vertices[vertex];
  return {p[0], p[1], p[2]};
}

}  // namespace

bool is_degenerate(std::span<const std::array<float, 3>> vertices, const std::array<std::uint32_t, 3>& triangle) {
  return CGAL::collinear(point_of(vertices, triangle[0]), point_of(vertices, triangle[1]),
                         point_of(vertices, triangle[2]));
}

bool triangles_overlap(std::span<const std::array<float, 3>> vertices, const std::array<std::uint32_t, 3>& one,
                       const std::array<std::uint32_t, 3>& other) {
  const auto point = [&](std::uint32_t vertex) { return point_of(vertices, vertex); };
  std::array<std::size_t, 3> common{};  // positions in `one` of the vertices that are also in `other`
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::find(other.begin(), other.end(), one[i]) != other.end()) common[count++] = i;
  const Kernel::Triangle_3 a(point(one[0]), point(one[1]), point(one[2]));
  const Kernel::Triangle_3 b(point(other[0]), point(other[1]), point(other[2]));
  if (count == 0) return CGAL::do_intersect(a, b);
  if (count == 1) {
    const std::size_t i = common[0];
    const auto j = static_cast<std::size_t>(std::find(other.begin(), other.end(), one[i]) - other.begin());
    const Kernel::Segment_3 facing_a(point(one[(i + 1) % 3]), point(one[(i + 2) % 3]));
    const Kernel::Segment_3 facing_b(point(other[(j + 1) % 3]), point(other[(j + 2) % 3]));
    return CGAL::do_intersect(facing_a, b) || CGAL::do_intersect(facing_b, a);
  }
  if (count == 3) return true;
  const std::size_t lone = 3 - common[0] - common[1];
  const std::uint32_t p = one[common[0]], q = one[common[1]];
  const std::uint32_t third =
      *std::find_if(other.begin(), other.end(), [&](std::uint32_t v) { return v != p && v != q; });
  const Point ends[2] = {point(p), point(q)};
  return CGAL::coplanar(ends[0], ends[1], point(one[lone]), point(third)) &&
         CGAL::coplanar_orientation(ends[0], ends[1], point(one[lone]), point(third)) == CGAL::POSITIVE;
}

}  // namespace fieldfab
