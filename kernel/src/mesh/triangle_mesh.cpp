#include "fieldfab/mesh/triangle_mesh.h"

#include <Eigen/Geometry>
#include <numeric>

#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

Vec3 corner(const TriangleMesh& mesh, std::uint32_t vertex) {
  const auto& p = mesh.vertices[vertex];
  return {p[0], p[1], p[2]};
}

/// Sum of `part(triangle)` over all triangles, the same for any number of threads.
template <class Part>
double sum_over(const std::vector<std::array<std::uint32_t, 3>>& triangles, const Part& part) {
  constexpr std::size_t some = 16384;
  std::vector<double> sums((triangles.size() + some - 1) / some);
  parallel_for(sums.size(), [&](std::size_t i) {
    const std::size_t last = std::min(triangles.size(), (i + 1) * some);
    double sum = 0;
    for (std::size_t t = i * some; t < last; ++t) sum += part(triangles[t]);
    sums[i] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

double TriangleMesh::volume() const {
  if (vertices.empty()) return 0;
  const Vec3 origin = corner(*this, 0);  // near the mesh, so that large coordinates cancel early
  const double six_volumes = sum_over(triangles, [&](const auto& t) {
    return (corner(*this, t[0]) - origin).cross(corner(*this, t[1]) - origin).dot(corner(*this, t[2]) - origin);
  });
  return six_volumes / 6;
}

double TriangleMesh::area() const {
  const double doubled = sum_over(triangles, [&](const auto& t) {
    const Vec3 a = corner(*this, t[0]);
    return (corner(*this, t[1]) - a).cross(corner(*this, t[2]) - a).norm();
  });
  return doubled / 2;
}

Box TriangleMesh::bounds() const {
  if (vertices.empty()) return {};
  Box box{corner(*this, 0), corner(*this, 0)};
  for (std::uint32_t i = 1; i < vertices.size(); ++i) box = hull(box, {corner(*this, i), corner(*this, i)});
  return box;
}

}  // namespace fieldfab
