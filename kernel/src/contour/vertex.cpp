#include "vertex.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace fieldfab::contouring {
namespace {

double farthest_plane(std::span<const SurfacePoint> points, const Vec3& vertex) {
  double farthest = 0;
  for (const SurfacePoint& point : points)
    farthest = std::max(farthest, std::abs(point.normal.cast<double>().dot(vertex - point.position.cast<double>())));
  return farthest;
}

/// Returns the point near `place` of all planes that touch the surface at two points or more, or `place` if there is
/// none. Flat faces have such planes; least squares put a vertex between them and those of curved faces beside them.
Vec3 on_shared_planes(const Vec3& place, std::span<const SurfacePoint> points, double size) {
  struct Plane {
    const SurfacePoint* first;
    bool shared;
  };
  constexpr std::size_t most = 6;  // more do not meet near one point
  std::array<Plane, most> planes;
  std::size_t count = 0;
  for (const SurfacePoint& point : points) {
    bool known = false;
    for (std::size_t i = 0; i < count && !known; ++i) {
      const SurfacePoint& first = *planes[i].first;
      const Eigen::Vector3f apart = point.position - first.position;
      known = (point.normal - first.normal).squaredNorm() < 1e-9F &&
              std::abs(static_cast<double>(apart.dot(point.normal))) < 1e-5 * size;
      planes[i].shared = planes[i].shared || (known && apart.norm() > 0.1 * size);
    }
    if (!known && count < most) planes[count++] = {&point, false};
  }
  Vec3 on_all = place;
  constexpr int rounds = 6;  // planes are not orthogonal; across a round face there are several, which do not meet
  for (int round = 0; round < rounds; ++round) {
    double farthest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!planes[i].shared) continue;
      const Vec3 normal = planes[i].first->normal.cast<double>();
      const double distance = normal.dot(on_all - planes[i].first->position.cast<double>());
      on_all -= distance * normal;
      farthest = std::max(farthest, std::abs(distance));
    }
    if (farthest < 1e-7 * size) return on_all;
  }
  return place;
}

}  // namespace

PlacedVertex place_vertex(std::span<const SurfacePoint> points, const Box& cell) {
  Vec3 mean = Vec3::Zero();
  for (const SurfacePoint& point : points) mean += point.position.cast<double>();
  mean /= static_cast<double>(points.size());

  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const SurfacePoint& point : points) {
    const Vec3 n = point.normal.cast<double>();
    normals += n * n.transpose();
    right += n * n.dot(point.position.cast<double>() - mean);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(normals);

  // Directions are added one by one, the best determined first; a direction is kept only if it
  // lowers the error enough.
  PlacedVertex best{mean, farthest_plane(points, mean), 0};
  const double worthwhile = 1e-4 * cell.size().x();
  Vec3 vertex = mean;
  for (int i = 2; i >= 0; --i) {
    const double strength = solver.eigenvalues()[i];
    if (strength <= 1e-7 * solver.eigenvalues()[2] || strength <= 0) break;
    const Vec3 direction = solver.eigenvectors().col(i);
    vertex += direction * (direction.dot(right) / strength);
    if (!cell.contains(vertex)) continue;
    const double error = farthest_plane(points, vertex);
    if (error < 0.5 * best.error && error < best.error - worthwhile) best = {vertex, error, 3 - i};
  }
  if (best.directions > 0 && best.error > 1e-6 * cell.size().x()) {
    vertex = on_shared_planes(best.position, points, cell.size().x());
    if (cell.contains(vertex)) best.position = vertex, best.error = farthest_plane(points, vertex);
  }
  return best;
}

}  // namespace fieldfab::contouring
