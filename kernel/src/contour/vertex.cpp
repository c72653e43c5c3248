#include "vertex.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace fieldfab::contouring {
namespace {

double farthest_plane(std::span<const SurfacePoint> points, const Vec3& vertex) {
  double farthest = 0;
  for (const SurfacePoint& point : points)
    farthest = std::max(farthest, std::abs(point.normal.cast<double>().dot(vertex - point.position.cast<double>())));
  return farthest;
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
  return best;
}

}  // namespace fieldfab::contouring
