#include <algorithm>
#include <cmath>

#include "fieldfab/cam/simulation.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

/// Farther than this is far, mm.
constexpr double far = 10;
/// Of a walk: how many steps, and the longest one, mm.
constexpr int steps = 8;
constexpr double longest_step = 2;

/// Signed distances of points from a solid: from each, a walk down its slope to the surface. Exact where the Field is a distance,
/// of second order near the surface of any smooth one; `far` where the walk does not arrive.
void signed_distances(const Field& target, const std::array<float, 3>* points, std::size_t count, float* out) {
  std::vector<float> x(count), y(count), z(count), value(count), dx(count), dy(count), dz(count), first(count);
  std::vector<double> left(count, far);
  for (std::size_t i = 0; i < count; ++i) x[i] = points[i][0], y[i] = points[i][1], z[i] = points[i][2];
  for (int step = 0; step < steps; ++step) {
    target.gradients({x.data(), y.data(), z.data(), count}, value.data(), {dx.data(), dy.data(), dz.data()});
    if (step == 0) first = value;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 slope(dx[i], dy[i], dz[i]);
      const double steepness = slope.norm();
      left[i] = steepness > 1e-9 && std::isfinite(value[i]) ? std::min(std::abs(value[i]) / steepness, far) : far;
      if (!(steepness > 1e-9) || !slope.allFinite() || !std::isfinite(value[i])) continue;
      const Vec3 way = slope * (std::clamp(value[i] / steepness, -longest_step, longest_step) / steepness);
      x[i] -= static_cast<float>(way.x()), y[i] -= static_cast<float>(way.y()), z[i] -= static_cast<float>(way.z());
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 way(x[i] - points[i][0], y[i] - points[i][1], z[i] - points[i][2]);
    const double distance = left[i] < 0.1 * way.norm() + 1e-3 ? std::min(way.norm(), far) : far;
    out[i] = static_cast<float>(std::copysign(distance, first[i]));
  }
}

}  // namespace

Deviation deviation_from(const Field& target, const TriangleMesh& mesh, double floor, Progress& progress) {
  Deviation result;
  const std::size_t count = mesh.vertices.size();
  result.at_vertex.resize(count);
  constexpr std::size_t block = 4096;
  parallel_for((count + block - 1) / block, [&](std::size_t b) {
    progress.check();
    const std::size_t first = b * block, length = std::min(block, count - first);
    // Vertices that follow each other lie near each other: what of the target may matter there is little of it.
    const auto place = [&](std::size_t i) { return Vec3(mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]); };
    Box box{place(first), place(first)};
    for (std::size_t i = first; i < first + length; ++i) box = hull(box, {place(i), place(i)});
    const Restriction here = target.restricted(box.grown(steps * longest_step + 0.01));
    signed_distances(*here.field, &mesh.vertices[first], length, &result.at_vertex[first]);
  });
  for (std::size_t i = 0; i < count; ++i)
    if (mesh.vertices[i][2] < floor) result.at_vertex[i] = 0;
  double area = 0, sum = 0, squares = 0;
  for (const float d : result.at_vertex) {
    result.deepest = std::max(result.deepest, -static_cast<double>(d));
    result.highest = std::max(result.highest, static_cast<double>(d));
  }
  result.histogram_from = -result.deepest, result.histogram_to = result.highest;
  constexpr std::size_t bins = 64;
  result.histogram.assign(bins, 0);
  const double range = std::max(result.histogram_to - result.histogram_from, 1e-12);
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    double mean = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = {mesh.vertices[t[i]][0], mesh.vertices[t[i]][1], mesh.vertices[t[i]][2]};
      mean += result.at_vertex[t[i]] / 3.0;
    }
    const Vec3 a = p[1] - p[0], b = p[2] - p[0];
    const double part =
        0.5 * Vec3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()).norm();
    area += part, sum += part * mean, squares += part * mean * mean;
    const double bin = (mean - result.histogram_from) / range * bins;
    result.histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, bins - 1.0))] += part;
  }
  if (area > 0) result.mean = sum / area, result.root_mean_square = std::sqrt(squares / area);
  return result;
}

}  // namespace fieldfab::cam
