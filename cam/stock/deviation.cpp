#include <algorithm>
#include <cmath>

#include "fieldfab/cam/simulation.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::cam {
namespace {

/// Farther than this is far, mm.
constexpr double far = 10;
/// Of a walk: how many steps, the longest one, and what is left when it has arrived, mm.
constexpr int steps = 8;
constexpr double longest_step = 2, arrived = 1e-5;

/// Walks from points down a Field's slope to its surface: signed distances, exact where the Field is a distance, of second order
/// near the surface of any smooth one; `far` where a walk does not arrive.
class Walks {
 public:
  Walks(const std::array<float, 3>* points, std::size_t count, float* distances)
      : points_(points), count_(count), distances_(distances), all_(count) {
    for (std::size_t i = 0; i < count; ++i) all_[i] = i;
  }

  void run(const Field& target) {
    // Most of a finished part is near: there, little of the target matters. What walks farther starts again.
    std::vector<std::size_t> far_ones;
    go(target, all_, 0.25, &far_ones);
    if (!far_ones.empty()) go(target, far_ones, steps * longest_step, nullptr);
  }

 private:
  [[nodiscard]] Vec3 place(std::size_t i) const { return {points_[i][0], points_[i][1], points_[i][2]}; }

  /// The points that leave their neighbourhood go to `leavers`, where there are such.
  void go(const Field& target, std::vector<std::size_t> points, double reach, std::vector<std::size_t>* leavers) {
    Box box{place(points[0]), place(points[0])};
    for (const std::size_t i : points) box = hull(box, {place(i), place(i)});
    const Restriction here = target.restricted(box.grown(reach + 0.01));
    std::vector<float> first(count_);
    for (const std::size_t i : points) at_.col(i) = place(i).cast<float>();
    for (int step = 0; step < steps && !points.empty(); ++step) {
      const std::size_t n = points.size();
      for (std::size_t k = 0; k < n; ++k) x_[k] = at_(0, points[k]), y_[k] = at_(1, points[k]), z_[k] = at_(2, points[k]);
      here.field->gradients({x_.data(), y_.data(), z_.data(), n}, value_.data(), {dx_.data(), dy_.data(), dz_.data()});
      std::size_t on_the_way = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = points[k];
        if (step == 0) first[i] = value_[k];
        const Vec3 slope(dx_[k], dy_[k], dz_[k]);
        const double steepness = slope.norm();
        const bool leads = steepness > 1e-9 && slope.allFinite() && std::isfinite(value_[k]);
        const double left = leads ? std::abs(value_[k]) / steepness : far;
        if (leads)
          at_.col(i) -= (slope * (std::clamp(value_[k] / steepness, -longest_step, longest_step) / steepness)).cast<float>();
        const double way = (at_.col(i).cast<double>() - place(i)).norm();
        if (leavers != nullptr && (way > reach || !leads)) {
          leavers->push_back(i);
          continue;
        }
        distances_[i] = static_cast<float>(std::copysign(left < 0.1 * way + 1e-3 ? std::min(way, far) : far, first[i]));
        if (left > arrived && leads) points[on_the_way++] = i;
      }
      points.resize(on_the_way);
    }
  }

  const std::array<float, 3>* points_;
  std::size_t count_;
  float* distances_;
  std::vector<std::size_t> all_;
  Eigen::Matrix3Xf at_{3, static_cast<Eigen::Index>(count_)};
  std::vector<float> x_ = std::vector<float>(count_), y_ = x_, z_ = x_, value_ = x_, dx_ = x_, dy_ = x_, dz_ = x_;
};

}  // namespace

Deviation deviation_from(const Field& target, const TriangleMesh& mesh, double floor, Progress& progress) {
  Deviation result;
  const std::size_t count = mesh.vertices.size();
  result.at_vertex.resize(count);
  constexpr std::size_t block = 4096;
  parallel_for((count + block - 1) / block, [&](std::size_t b) {
    progress.check();
    const std::size_t first = b * block, length = std::min(block, count - first);
    Walks(&mesh.vertices[first], length, &result.at_vertex[first]).run(target);
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
